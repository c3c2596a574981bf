#include "exact/range_free.h"

#include <cfenv>
#include <limits>

#include "exact/mpfr_number.h"
#include "kernel/scalar.h"

namespace axiscert {

template <class Real>
RoundedBits rounded_bits(const Query<Real>& q, Strictness strictness) {
  std::feclearexcept(FE_OVERFLOW | FE_UNDERFLOW);
  const Sides<Real> sides = reference_sides(q);
  const bool left_range = std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW) != 0;
  const ComparisonBits reference = bits_of(sides, strictness);
  if (!left_range) return {reference, reference};
  using Unbounded = Mpfr<std::numeric_limits<Real>::digits>;
  const auto unbounded = published_sides<Unbounded>(q, [](Real x) { return Unbounded(x); });
  return {bits_of(unbounded, strictness), reference};
}
template RoundedBits rounded_bits<float>(const Query<float>&, Strictness);
template RoundedBits rounded_bits<double>(const Query<double>&, Strictness);

}  // namespace axiscert
