// Triangles with two vertices very near each other.
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

// The two vertices lie about the origin; where the triangle is then moved away, rounding can make them one.
template <class Real>
Query<Real> needle(Stream& random, std::uint64_t position) {
  constexpr int most_halvings = sizeof(Real) == 4 ? 30 : 60;
  const int halvings = 1 + static_cast<int>(position % most_halvings);
  const auto spread = shapes::vertices_in_cube<Real>(random);
  const auto vertices = shapes::shuffled<Real>(
      random, {shapes::scaled(spread[0], -halvings), shapes::scaled(spread[1], -halvings), spread[2]});

  Query<Real> q = shapes::placed(random, vertices, halvings);
  q.r = shapes::aimed_radius(random, q);
  return q;
}

}  // namespace

extern const Family needle_family = {
    "needle",
    "two vertices near each other, at 2^-1 to 2^-30 of the distance to the third (2^-60 in binary64)",
    1,
    false,
    needle<float>,
    needle<double>};

}  // namespace axiscert
