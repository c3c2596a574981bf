#include "fuzz/instruments/effort.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "exact/judge/oracles.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::uint64_t two_to(int exponent) { return std::uint64_t{1} << exponent; }

// `published` takes some 2 and 20 minutes at quick and standard, on two cores (docs/certify.md).
constexpr EnumArray<Effort, EffortSize> effort_sizes = {EffortSize{two_to(8), two_to(16), 16, 256, two_to(6)},
                                                        EffortSize{two_to(19), two_to(26), two_to(11), 4, two_to(12)},
                                                        EffortSize{two_to(22), two_to(30), two_to(14), 2, two_to(12)},
                                                        EffortSize{two_to(24), two_to(33), two_to(16), 1, two_to(13)}};

// A query of a predicate without filters costs a hundred times as much; a kernel in another process some ten
// microseconds.
constexpr std::uint64_t divisor_without_filters = 64, divisor_if_slow = 8, least_asked = 16;
// Fewer than 59 right answers are no evidence about a family (reports/wording/evidence.h). Four times as many cost
// next to nothing with filters, and are enough for a family of which a third is queries, as `nonfinite`.
constexpr std::uint64_t least_trials = two_to(6), least_trials_with_filters = two_to(8);

// A family whose queries take the oracles many times as long is asked less.
constexpr int dear_cost = 10;

}  // namespace

Effort parse_effort(std::string_view text) {
  for (const Effort effort : enumerators<Effort>) {
    if (effort_names[effort] == text) return effort;
  }
  const std::vector<std::string_view> known(effort_names.begin(), effort_names.end());
  throw Error(unknown_name("effort", "efforts", text, known));
}

EffortSize size_of(Effort effort, const Predicate& predicate, bool is_slow) {
  EffortSize size = effort_sizes[effort];
  const bool has_filters = oracles_of(predicate).has_filters();
  const std::uint64_t divisor = (has_filters ? 1 : divisor_without_filters) * (is_slow ? divisor_if_slow : 1);
  size.trials = std::max(has_filters ? least_trials_with_filters : least_trials, size.trials / divisor);
  size.evaluations = std::max(least_asked, size.evaluations / divisor);
  size.probes = std::max(least_asked, size.probes / (is_slow ? divisor_if_slow : 1));
  if (!has_filters) size.mutant_trials = std::max(least_asked, size.mutant_trials / 8);
  return size;
}

std::uint64_t trials_of(Effort effort, const Predicate& predicate, std::string_view source, bool is_slow) {
  const std::uint64_t trials = size_of(effort, predicate, is_slow).trials;
  for (const Family* family : families_of(predicate)) {
    if (family->name == source && family->cost >= dear_cost)
      return std::max(least_trials, trials / static_cast<std::uint64_t>(family->cost));
  }
  return trials;
}

std::uint64_t trials_of(Effort effort, const Source& source, bool is_slow) {
  return trials_of(effort, source.predicate(), source.name(), is_slow);
}

}  // namespace axiscert
