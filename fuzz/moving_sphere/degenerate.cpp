// Triangles of zero area: on a line, and with equal vertices.
#include "fuzz/moving_sphere/parts.h"

namespace axiscert::moving_sphere {
namespace {

// Three points of a line in any order; D in the line, across it, or any.
template <class Real>
Numbers<Real> motion_at_a_line(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, FeatureKind::edge);
  const auto on_line = [&](std::int64_t bound) { return t.along * random.integer(-bound, bound); };
  const Whole a = t.at + on_line(3), b = t.at + on_line(3), c = t.at + on_line(3);
  const std::uint64_t way = position % 3;
  const Whole d = way == 0 ? on_line(4) : way == 1 ? across(random, t.along) : shapes::integers(random, 40);
  const std::int64_t s = random.integer(0, 1);
  const Whole p = t.at + on_line(4) + t.normal - d * s;
  MovingQuery<Real> q = spread<Real>(random, {a, b, c}, p, d, random.integer(t.r - 1, t.r + 1));
  nudge(random, position, q);
  return q;
}

// Each pair in turn, then all three; otherwise arbitrary.
template <class Real>
Numbers<Real> motion_at_equal_vertices(Stream& random, std::uint64_t position) {
  auto v = shapes::vertices_in_cube<Real>(random);
  const std::uint64_t which = position % 4;
  if (which == 3) v[1] = v[2] = v[0];
  else v[(which + 1) % 3] = v[which];
  const Vec3<Real> p = shapes::in_cube<Real>(random), d = shapes::in_cube<Real>(random);
  return MovingQuery<Real>{v[0], v[1], v[2], p, d, random.unit<Real>()};
}

}  // namespace

extern const Family moving_sphere_line_sweep_family = moving_family<motion_at_a_line<float>, motion_at_a_line<double>>(
    "moving-sphere/line_sweep", situation::zero_area,
    "three points of one line; D in the line, across it, or any, in turn");
extern const Family moving_sphere_repeated_sweep_family =
    moving_family<motion_at_equal_vertices<float>, motion_at_equal_vertices<double>>(
        "moving-sphere/repeated_sweep", situation::zero_area,
        "two equal vertices (A = B, B = C, C = A) or three, in turn");

}  // namespace axiscert::moving_sphere
