// One number out of thirteen that is not finite, has the wrong sign, or is a zero of either sign.
#include <bit>
#include <cmath>
#include <limits>

#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Real unusual(std::uint64_t kind, Real usual) {
  using Limits = std::numeric_limits<Real>;
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  // A quiet NaN without payload; by its bits, since its sign and payload enter the digests.
  constexpr Bits nan = (~Bits{0} >> 1) & ~((Bits{1} << (Limits::digits - 2)) - 1);
  switch (kind) {
    case 0:
      return std::bit_cast<Real>(nan);
    case 1:
      return Limits::infinity();
    case 2:
      return -Limits::infinity();
    case 3:
      return -std::abs(usual);  // an invalid radius
    case 4:
      return -Limits::denorm_min();  // the least of those
    case 5:
      return Real(0);
    case 6:
      return Real(-0.0);
    default:
      return Limits::max();  // valid; its square is not finite
  }
}

// Each place in turn with each kind. One query in four carries a second one, of any kind at any place.
template <class Real>
Query<Real> nonfinite(Stream& random, std::uint64_t position) {
  std::array<Real, coordinate_count> v;
  for (Real& x : v) x = random.symmetric<Real>();
  v[12] = std::abs(v[12]);
  const std::array<Real, coordinate_count> usual = v;
  if (random.below(4) == 0) {
    const std::size_t place = random.below(coordinate_count);
    v[place] = unusual(random.below(8), usual[place]);
  }
  const std::size_t place = position % coordinate_count;
  v[place] = unusual(position / coordinate_count % 8, usual[place]);
  return from_coordinates(v);
}

}  // namespace

extern const Family nonfinite_family = {
    "nonfinite",
    "NaN, infinities, negative numbers and zeros of both signs in each of the thirteen places in turn",
    2,
    false,
    nonfinite<float>,
    nonfinite<double>};

}  // namespace axiscert
