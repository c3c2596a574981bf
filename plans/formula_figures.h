// The figures of the instruments that measure formulae, by what is asked for: kernels and queries by names.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "kernel/base/enums.h"
#include "kernel/base/error.h"
#include "reports/instrument/instrument.h"
#include "plans/instrument_plan.h"

namespace axiscert {

// Each throws Error for what does not exist or cannot be measured, in the words of the command of its name.

// The enumerator of this name; `option` is "--rounding " or "rounding=". Throws Error that lists them.
template <Enumeration Enum>
Enum enumerator_of(std::string_view option, const std::string& text) {
  if (const auto found = enumerator_named<Enum>(text)) return *found;
  std::vector<std::string_view> known;
  for (const Enum each : enumerators<Enum>) known.push_back(name(each));
  throw Error(fmt::format("{}'{}': there are: {}", option, text, fmt::join(known, ", ")));
}

// Queries of each family, where none are given.
inline constexpr std::uint64_t ladder_trials = std::uint64_t{1} << 14, precision_trials = std::uint64_t{1} << 11,
                               condition_trials = std::uint64_t{1} << 14;
inline constexpr std::uint64_t default_rounding_seeds = 3;

struct LadderOptions : InstrumentOptions {
  bool no_speed = false, factorial = false;
};

InstrumentReport ladder_figures(const LadderOptions& options, const ShowProgress& show);

struct PrecisionOptions : InstrumentOptions {
  std::vector<int> bits;
  std::vector<std::string> numbers;
  std::string rounding = "nearest", contraction = "none";
  std::optional<std::uint64_t> rounding_seeds;  // of a rounding by chance alone
  bool round_inputs = false;
};
InstrumentReport precision_figures(const PrecisionOptions& options, const ShowProgress& show);

struct ConditionOptions : InstrumentOptions {
  std::uint64_t flips = 256, sample = 64;
};
InstrumentReport condition_figures(const ConditionOptions& options, const ShowProgress& show);

}  // namespace axiscert
