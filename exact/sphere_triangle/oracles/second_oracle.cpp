#include "exact/sphere_triangle/oracles/second_oracle.h"

#include "exact/numbers/mpfr_number.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// Wide enough for a degree-6 polynomial in numbers that span 277 (binary32) or 2,098 (binary64) bits. Not relied upon:
// MPFR's inexact flag is checked.
template <class Real>
inline constexpr int exact_bits = sizeof(Real) == 4 ? 1700 : 12700;

}  // namespace

template <class Real>
SecondOpinion second_opinion(const Query<Real>& q) {
  using Number = Mpfr<exact_bits<Real>>;
  mpfr_clear_inexflag();
  const auto centred = centred_as<Number>(q, [](Real x) { return Number(x); });
  const Number zero, one(1);
  const auto by_value = [](const Number& x, const Number& y) { return order(x, y); };
  const auto distance = walked_squared_distance(centred, zero, one, by_value);
  SecondOpinion opinion{0, 0, order(distance.numerator, centred.rr * distance.denominator)};
  const auto sides = published_sides(centred, zero);
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const int sign = order(sides.lhs[i], sides.rhs[i]);
    if (sign > 0) opinion.strict |= one_bit<SignBits>(i);
    if (sign == 0) opinion.ties |= one_bit<SignBits>(i);
  }
  if (mpfr_inexflag_p()) throw HarnessFault("the second oracle rounded: its precision is too small for this query");
  return opinion;
}
template SecondOpinion second_opinion<float>(const Query<float>&);
template SecondOpinion second_opinion<double>(const Query<double>&);

}  // namespace axiscert
