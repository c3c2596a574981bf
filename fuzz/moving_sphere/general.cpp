// Motions without a special place: anywhere, from afar, of great and small lengths, and none.
#include "fuzz/moving_sphere/parts.h"

namespace axiscert::moving_sphere {
namespace {

template <class Real>
MovingQuery<Real> motion_anywhere(Stream& random) {
  const auto [a, b, c] = shapes::vertices_in_cube<Real>(random);
  const Vec3<Real> p = shapes::in_cube<Real>(random), d = shapes::in_cube<Real>(random);
  return {a, b, c, p + p, d + d, random.unit<Real>() * Real(0.5)};
}

template <class Real>
Numbers<Real> general_motion(Stream& random, std::uint64_t) {
  return motion_anywhere<Real>(random);
}

// The centre is aimed at a point beside the triangle, about r from it.
template <class Real>
Numbers<Real> approaching_motion(Stream& random, std::uint64_t position) {
  MovingQuery<Real> q = motion_anywhere<Real>(random);
  const int exponent = 4 + static_cast<int>(position % 23);
  const Vec3<Real> target = q.a + shapes::in_cube<Real>(random) * q.r, way = shapes::in_cube<Real>(random);
  q.p = target - way * (q.r * std::ldexp(Real(1), exponent));
  q.d = (target - q.p) * (Real(1) + random.unit<Real>());
  return q;
}

template <class Real>
Numbers<Real> with_length(Stream& random, int exponent) {
  MovingQuery<Real> q = motion_anywhere<Real>(random);
  q.p = q.p * Real(0.5);
  q.d = q.d * std::ldexp(Real(1), exponent);
  return q;
}
template <class Real>
Numbers<Real> huge_motion(Stream& random, std::uint64_t position) {
  return with_length<Real>(random, 6 + static_cast<int>(position % 32));
}
// From 2^-20 on P + D rounds to P in binary32; in binary64 from 2^-50 on.
template <class Real>
Numbers<Real> tiny_motion(Stream& random, std::uint64_t position) {
  const int least = sizeof(Real) == 4 ? 8 : 36;
  return with_length<Real>(random, -least - static_cast<int>(position % 32));
}

// D = 0: the static query. Anywhere and touching, in turn.
template <class Real>
Numbers<Real> no_motion(Stream& random, std::uint64_t position) {
  if (position % 2 == 0) {
    MovingQuery<Real> q = motion_anywhere<Real>(random);
    q.p = q.p * Real(0.5);
    q.d = {0, 0, 0};
    return q;
  }
  const TouchedTriangle t = touched(random, feature_in_turn(position / 2));
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal, {0, 0, 0}, t.r);
  nudge(random, position / 2, q);
  return q;
}

template <class Real>
Numbers<Real> lattice_motion(Stream& random, std::uint64_t position) {
  const std::int64_t most = sizeof(Real) == 4 ? 3 : 90,
                     m = std::array{std::int64_t{1}, std::int64_t{2}, most}[position % 3];
  return small_integers<Real>(random, m);
}

}  // namespace

extern const Family moving_sphere_general_family = moving_family<general_motion<float>, general_motion<double>>(
    "moving-sphere/general", situation::everyday,
    "triangle in the unit cube, path through the cube of twice its size, r below 0.5");
extern const Family moving_sphere_approach_family =
    moving_family<approaching_motion<float>, approaching_motion<double>>(
        "moving-sphere/approach", situation::far, "from 2^4 to 2^26 radii away, past a vertex at about r");
extern const Family moving_sphere_huge_d_family = moving_family<huge_motion<float>, huge_motion<double>>(
    "moving-sphere/huge_d", situation::far, "the displacement of general times 2^6 to 2^37");
extern const Family moving_sphere_tiny_d_family = moving_family<tiny_motion<float>, tiny_motion<double>>(
    "moving-sphere/tiny_d", situation::no_motion, "the displacement of general so small that P + D is, or nearly, P");
extern const Family moving_sphere_zero_d_family = moving_family<no_motion<float>, no_motion<double>>(
    "moving-sphere/zero_d", situation::no_motion, "D = 0, the static query: anywhere and touching in turn");
extern const Family moving_sphere_lattice_family = moving_family<lattice_motion<float>, lattice_motion<double>>(
    "moving-sphere/lattice", situation::small_integers,
    "small integers, radii in halves: every operation of twenty is exact", true);

}  // namespace axiscert::moving_sphere
