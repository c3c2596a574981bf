#include "fuzz/record/margins.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "exact/judge/side_error.h"
#include "fuzz/record/tally.h"
#include "fuzz/text/json_form.h"

namespace axiscert {
namespace {

// The k with 2^k < x <= 2^(k+1), for a finite x > 0.
int exponent_of(double x) {
  int exponent;
  const double half = std::frexp(x, &exponent);  // x = half * 2^exponent, 1/2 <= half < 1
  return half == 0.5 ? exponent - 2 : exponent - 1;
}

Rational power_of_two(int exponent) {
  const Rational power(mpz_class(1) << static_cast<unsigned>(std::abs(exponent)));
  return exponent < 0 ? Rational(1 / power) : power;
}

}  // namespace

// The margin in u equals the error of a kernel that computed 0 > 0: its sides differ from the exact ones by the margin.
template <class Real>
std::optional<int> margin_exponent(const ExactComparison& exact) {
  const SideError margin(Real(0), Real(0), exact);
  if (exact.is_undefined || exact.is_times_root) return std::nullopt;
  // 0/0 and a margin of exactly 0 are ties.
  if (margin.kind() == SideError::Kind::without_scale || margin.upper() == 0) return tied_margin;
  if (margin.lower() > 0 && std::isfinite(margin.upper())) {
    const int low = exponent_of(margin.lower()), high = exponent_of(margin.upper());
    if (low == high || high <= least_margin_exponent) return std::max(low, least_margin_exponent);
  }
  if (!margin.exceeds(0)) return tied_margin;
  // No margin exceeds its scale: 1/u. Invariant: the margin is above 2^low, or low is the least exponent; it is not
  // above 2^high.
  int low = least_margin_exponent, high = std::numeric_limits<Real>::digits;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (margin.exceeds(power_of_two(middle)) ? low : high) = middle;
  }
  return low;
}
template std::optional<int> margin_exponent<float>(const ExactComparison&);
template std::optional<int> margin_exponent<double>(const ExactComparison&);

Json JsonForm<MarginCounts>::write(const MarginCounts& counts) {
  Json json = Json::object();
  for (const auto& [exponent, count] : counts.by_exponent) {
    json[exponent == tied_margin ? "tie" : std::to_string(exponent)] = count;
  }
  return json;
}
void JsonForm<MarginCounts>::read(const JsonPlace& place, MarginCounts& into) {
  place.require_type(place.value().is_object(), "object");
  into = {};
  for (const auto& [name, value] : place.value().items()) {
    int exponent = tied_margin;
    while (exponent <= greatest_margin_exponent &&
           (exponent == tied_margin ? name != "tie" : name != std::to_string(exponent)))
      ++exponent;
    if (exponent > greatest_margin_exponent) place.at(name).refuse("under a name that is not in the schema");
    read_json(place.at(name), into.by_exponent[exponent]);
  }
}
Json JsonForm<MarginCounts>::schema() {
  return {
      {"description",
       "Under k the queries with a margin above 2^k u and not above 2^(k+1) u; -8 includes all below it; tie: lhs = "
       "rhs. A missing count is zero."},
      {"type", "object"},
      {"propertyNames", {{"pattern", "^(tie|0|-[1-8]|[1-9]|[1-4][0-9]|5[0-2])$"}, {"maxLength", 3}}},
      {"additionalProperties", json_schema_of<std::uint64_t>()}};
}

template <class Real>
void count_margins(NamedValues<ComparisonTally>& tallies, const ExactSides& sides, ComparisonBits exact,
                   ComparisonBits computed) {
  const ComparisonBits wrong = exact ^ computed;
  for (std::size_t i = 0; i < sides.lhs.size(); ++i) {
    MarginTally& tally = tallies[i].margins;
    if (const std::optional<int> exponent = margin_exponent<Real>(sides.comparison(i)))
      ++(has_bit(wrong, i) ? tally.wrong : tally.right).by_exponent[*exponent];
  }
}
template void count_margins<float>(NamedValues<ComparisonTally>&, const ExactSides&, ComparisonBits, ComparisonBits);
template void count_margins<double>(NamedValues<ComparisonTally>&, const ExactSides&, ComparisonBits, ComparisonBits);

}  // namespace axiscert
