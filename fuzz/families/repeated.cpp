// Triangles with equal vertices: each pair in turn, then all three.
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> repeated(Stream& random, std::uint64_t position) {
  auto vertices = shapes::vertices_in_cube<Real>(random);
  const std::size_t which = position % 4;
  if (which < 3) {
    vertices[shapes::next(which)] = vertices[which];
  } else {
    vertices[1] = vertices[2] = vertices[0];
  }
  Query<Real> q = shapes::query(vertices, shapes::in_cube<Real>(random));
  q.r = shapes::aimed_radius(random, q);
  return q;
}

}  // namespace

extern const Family repeated_family = {
    "repeated",
    "two equal vertices (A = B, B = C, C = A) or three, in turn; otherwise arbitrary",
    1,
    false,
    repeated<float>,
    repeated<double>};

}  // namespace axiscert
