// Triangles with equal corners: each pair in turn, then all three.
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> repeated(Stream& random, std::uint64_t position) {
  auto corners = shapes::corners_in_cube<Real>(random);
  const std::size_t which = position % 4;
  if (which < 3) {
    corners[shapes::next(which)] = corners[which];
  } else {
    corners[1] = corners[2] = corners[0];
  }
  Query<Real> q = shapes::query(corners, shapes::in_cube<Real>(random));
  q.r = shapes::aimed_radius(random, q);
  return q;
}

}  // namespace

extern const Family repeated_family = {"repeated",
                                       "two equal corners (A = B, B = C, C = A) or three, in turn; otherwise arbitrary",
                                       1,
                                       false,
                                       repeated<float>,
                                       repeated<double>};

}  // namespace axiscert
