#include "fuzz/campaign/counts/margins.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "exact/trait/side_error.h"

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
  if (exact.is_undefined) return std::nullopt;
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

void MarginTally::add(std::size_t comparison, int exponent, MarginCount more) {
  MarginCount& count = counts_[{static_cast<std::uint8_t>(comparison), static_cast<std::int8_t>(exponent)}];
  count.right += more.right;
  count.wrong += more.wrong;
}

void MarginTally::merge(const MarginTally& other) {
  for (const auto& [key, count] : other.counts_) add(key.first, key.second, count);
}

template <class Real>
void count_margins(MarginTally& tally, const ExactSides& sides, ComparisonBits exact, ComparisonBits computed) {
  const ComparisonBits wrong = exact ^ computed;
  for (std::size_t i = 0; i < sides.lhs.size(); ++i) {
    const std::optional<int> exponent = margin_exponent<Real>(sides.comparison(i));
    const bool is_wrong = has_bit(wrong, i);
    if (exponent) tally.add(i, *exponent, {!is_wrong, is_wrong});
  }
}
template void count_margins<float>(MarginTally&, const ExactSides&, ComparisonBits, ComparisonBits);
template void count_margins<double>(MarginTally&, const ExactSides&, ComparisonBits, ComparisonBits);

}  // namespace axiscert
