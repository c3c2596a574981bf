// Floating-point formats by name: what research, machines and standards call them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/numbers/floating.h"

namespace axiscert {

inline constexpr int least_bits = 2, greatest_bits = FloatingScope::greatest_precision;

struct NumberFormat {
  std::string name;  // "bfloat16", or "bits=11,emax=15"
  int bits;          // of the significand, the leading one included
  // Empty: those of the queries' precision, whatever that is.
  std::optional<ExponentLimits> exponents = {};

  bool operator==(const NumberFormat&) const = default;
};

// A format of so many bits, "bits=P", with the exponents of the queries.
NumberFormat format_of_bits(int bits);

// The formats that have a name, and what each is.
struct NamedFormat {
  NumberFormat format;
  std::string_view about;
};
const std::vector<NamedFormat>& named_formats();
// "bfloat16, binary16, ... or bits=P[,emax=E]": what parse_number_format() takes.
std::string number_formats_text();

// The format of a name, or bits=P,emax=E: P bits, exponents from 1 - E to E, gradual underflow and infinities, as in
// IEEE 754; bits=P alone: format_of_bits(). Throws Error that says what was given and what would be right.
NumberFormat parse_number_format(std::string_view text);

// How each operation is rounded, as it is asked for.
enum class RoundingRule : std::uint8_t { nearest, up, down, zero, faithful, stochastic };
template <>
inline constexpr std::size_t enum_count<RoundingRule> = 6;
inline constexpr EnumArray<RoundingRule, std::string_view> rounding_rule_names = {"nearest", "up",       "down",
                                                                                  "zero",    "faithful", "stochastic"};
constexpr std::string_view name(RoundingRule rule) { return rounding_rule_names[rule]; }
constexpr bool is_by_chance(RoundingRule rule) {
  return rule == RoundingRule::faithful || rule == RoundingRule::stochastic;
}

// The operations in a format by a rule; `exponents` where the format has none of its own.
FloatingFormat floating(const NumberFormat& format, RoundingRule rule, const ExponentLimits& exponents,
                        std::uint64_t seed = 0);

}  // namespace axiscert
