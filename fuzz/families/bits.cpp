// Uniform finite bit patterns: every exponent as likely as another, thirteen sizes in one query.
#include <bit>
#include <limits>

#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> bits(Stream& random, std::uint64_t) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  constexpr int digits = std::numeric_limits<Real>::digits, width = 8 * sizeof(Real);
  constexpr Bits sign = Bits{1} << (width - 1), top_of_exponent = sign >> 1;
  constexpr Bits exponent = (sign - 1) & ~((Bits{1} << (digits - 1)) - 1);
  std::array<Real, coordinate_count> v;
  for (Real& x : v) {
    Bits pattern;
    if constexpr (width == 32) pattern = random.word();
    else pattern = random.bits();
    if ((pattern & exponent) == exponent) pattern ^= top_of_exponent;  // infinities and NaNs come down to [1, 2)
    if (&x == &v[12]) pattern &= ~sign;
    x = std::bit_cast<Real>(pattern);
  }
  return from_coordinates(v);
}

}  // namespace

extern const Family bits_family = {
    "bits", "uniform finite bit patterns, the radius without its sign", 2, false, bits<float>, bits<double>};

}  // namespace axiscert
