#include "kernel/plugin/difference.h"

#include <fmt/format.h>

#include <cmath>

namespace axiscert::plugin {
namespace {

template <class Real>
bool same(Real a, Real b) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
  return a == b && std::signbit(a) == std::signbit(b);
}

// The name of the comparison, or the number of a bit beyond the last one.
std::string comparison_text(const Predicate& predicate, std::size_t which) {
  return which < predicate.comparisons.size() ? std::string(predicate.comparisons[which].name) : std::to_string(which);
}

template <class Real>
std::optional<std::string> difference_at(const Predicate& predicate, const Outputs<Real>& a, std::size_t i,
                                         const Outputs<Real>& b, std::size_t j) {
  if (a.verdicts[i] != b.verdicts[j]) {
    return fmt::format("verdict {}, then {}", verdict_text(a.verdicts[i]), verdict_text(b.verdicts[j]));
  }
  for (std::size_t k = 0; k < b.measures.size(); ++k) {
    const Real before = a.measures[k][i], after = b.measures[k][j];
    if (!same(before, after)) return fmt::format("{} {:a}, then {:a}", predicate.measures[k].name, before, after);
  }
  if (b.bits.empty()) return std::nullopt;
  if (const std::uint64_t flipped = a.bits[i] ^ b.bits[j]) {
    const std::size_t which = first_bit(flipped);
    const int before = has_bit(a.bits[i], which);
    return fmt::format("comparison {} {}, then {}", comparison_text(predicate, which), before, 1 - before);
  }
  for (std::size_t k = 0; k < b.lhs.size() && !b.lhs[k].empty(); ++k) {
    for (const auto& [side, before, after] :
         {std::tuple{"lhs", a.lhs[k][i], b.lhs[k][j]}, std::tuple{"rhs", a.rhs[k][i], b.rhs[k][j]}}) {
      if (!same(before, after)) {
        return fmt::format("{} of {} {:a}, then {:a}", side, predicate.comparisons[k].name, before, after);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::string verdict_text(std::uint8_t verdict) {
  if (is_verdict(verdict)) return std::string(name(static_cast<Verdict>(verdict)));
  return fmt::format("{}, which is no verdict", verdict);
}

template <class Real>
std::optional<Difference> first_difference(const Predicate& predicate, const Outputs<Real>& a, std::size_t first,
                                           const Outputs<Real>& b) {
  for (std::size_t i = 0; i < b.verdicts.size(); ++i) {
    if (auto detail = difference_at(predicate, a, first + i, b, i)) return Difference{i, std::move(*detail)};
  }
  return std::nullopt;
}
template std::optional<Difference> first_difference(const Predicate&, const Outputs<float>&, std::size_t,
                                                    const Outputs<float>&);
template std::optional<Difference> first_difference(const Predicate&, const Outputs<double>&, std::size_t,
                                                    const Outputs<double>&);

}  // namespace axiscert::plugin
