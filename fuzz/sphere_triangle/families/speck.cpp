// Exact ties, with specks in place of zero coordinates: numbers from a rounding error of the query's size down to the
// least number there is. The part that decides such a query, if any part does, lies hundreds of bits below all others,
// where products underflow: arithmetic that is exact except for underflow answers as if the specks were absent.
#include "fuzz/queries/family.h"
#include "fuzz/queries/floats.h"
#include "fuzz/queries/random.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// A tie is multiplied by up to this power of two, or by its inverse, without rounding or overflow.
template <class Real>
constexpr int most_doublings = sizeof(Real) == 4 ? 80 : 120;

// 1 or 3 times a power of two below `size`, with either sign.
template <class Real>
Real speck(Stream& random, int size) {
  using Limits = std::numeric_limits<Real>;
  constexpr int least = Limits::min_exponent - Limits::digits;
  const auto exponent = static_cast<int>(random.integer(least, size - Limits::digits));
  // A third of the specks are small multiples of the least number.
  const Real unit = std::ldexp(Real(1), random.below(3) == 0 ? least : exponent);
  const Real x = random.coin() ? unit : 3 * unit;
  return random.coin() ? x : -x;
}

// The centre is at the origin, so that at least three coordinates are zero.
template <class Real>
Query<Real> specked_tie(Stream& random, std::uint64_t position) {
  const Query<Real> tie = touching_integers<Real>(random, position);
  auto v = coordinates(Query<Real>{tie.a - tie.p, tie.b - tie.p, tie.c - tie.p, {0, 0, 0}, tie.r});
  const auto doublings = static_cast<int>(random.integer(-most_doublings<Real>, most_doublings<Real>));
  scale_by_power_of_two(v, doublings);
  for (std::size_t k = 0; k < 12; ++k) {
    if (v[k] == 0 && random.coin()) v[k] = speck<Real>(random, doublings);
  }
  return from_coordinates(v);
}

}  // namespace

extern const Family speck_family = {
    sphere_triangle_predicate,
    "speck",
    "exact ties times powers of two, with specks for zeros: a rounding of them down to the least numbers there are",
    1,
    false,
    fill_one_by_one<specked_tie<float>>,
    fill_one_by_one<specked_tie<double>>,
    std::nullopt,
    30};

}  // namespace axiscert
