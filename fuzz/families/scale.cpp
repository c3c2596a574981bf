// Clear queries at every power of two of the precision: what goes wrong is range, not rounding.
#include <cmath>
#include <limits>

#include "fuzz/boundary.h"
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

// From the power that leaves one bit of a subnormal to the one whose products stay just finite.
template <class Real>
int exponent(std::uint64_t position) {
  using Limits = std::numeric_limits<Real>;
  constexpr int least = Limits::min_exponent - Limits::digits, greatest = Limits::max_exponent - 1;
  return least + static_cast<int>(position % (greatest - least + 1));
}

template <class Real>
Query<Real> scale(Stream& random, std::uint64_t position) {
  const auto vertices = shapes::vertices_in_cube<Real>(random);
  Query<Real> q = shapes::query(vertices, shapes::in_cube<Real>(random));
  // Half the distance or less, or twice the distance or more, and below two.
  const Real share = random.unit<Real>() / 2, distance = radius_at_distance(q);
  const bool separated = random.coin() || distance >= Real(0.5);
  q.r = separated ? distance * share : distance * 2 + share;
  const int k = exponent<Real>(position);
  return {shapes::scaled(q.a, k), shapes::scaled(q.b, k), shapes::scaled(q.c, k), shapes::scaled(q.p, k),
          std::ldexp(q.r, k)};
}

}  // namespace

extern const Family scale_family = {
    "scale",
    "clear queries (r at most half the distance, or at least twice) times every power of two in turn",
    2,
    false,
    scale<float>,
    scale<double>};

}  // namespace axiscert
