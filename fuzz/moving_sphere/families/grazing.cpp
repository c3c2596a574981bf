// Motions whose least distance is r exactly, or by ulps not: in the plane n.(Z - X) = r r.
#include "fuzz/moving_sphere/families/parts.h"

namespace axiscert::moving_sphere {
namespace {

// The centre is at X + n at s / k of its motion k d.
template <class Real>
MovingQuery<Real> passing(Stream& random, const TouchedTriangle& t, const Whole& d) {
  const std::int64_t k = random.integer(1, 4), s = random.integer(0, k);
  return spread<Real>(random, t.vertex, t.at + t.normal - d * s, d * k, t.r);
}

template <class Real>
Numbers<Real> grazing_motion(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  MovingQuery<Real> q = passing<Real>(random, t, across(random, t.normal));
  nudge(random, position, q);
  return q;
}

// Over the face, or beside it at the height of its plane, D.V = 0.
template <class Real>
MovingQuery<Real> over_the_face(Stream& random) {
  TouchedTriangle t = touched(random, FeatureKind::face);
  const std::int64_t away = random.integer(0, 2);
  t.at = t.at + across(random, t.normal) * away;
  return passing<Real>(random, t, across(random, t.normal));
}
template <class Real>
Numbers<Real> sliding_motion(Stream& random, std::uint64_t position) {
  MovingQuery<Real> q = over_the_face<Real>(random);
  nudge(random, position, q);
  return q;
}
// D.V of a few ulps.
template <class Real>
Numbers<Real> skimming_motion(Stream& random, std::uint64_t position) {
  MovingQuery<Real> q = over_the_face<Real>(random);
  const int ulps = static_cast<int>(random.integer(-4, 4));
  Real& coordinate = position % 3 == 0 ? q.d.x : position % 3 == 1 ? q.d.y : q.d.z;
  coordinate = step_ulps(coordinate, ulps);
  nudge(random, position, q);
  return q;
}

// D is parallel to AB: M = 0.
template <class Real>
Numbers<Real> motion_along_an_edge(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, FeatureKind::edge);
  Whole d = t.along * random.integer(1, 3);
  if (random.coin()) d = Whole{0, 0, 0} - d;
  MovingQuery<Real> q = passing<Real>(random, t, d);
  nudge(random, position, q);
  return q;
}

}  // namespace

extern const Family moving_sphere_graze_family = moving_family<grazing_motion<float>, grazing_motion<double>>(
    "moving-sphere/graze", situation::touching,
    "past a vertex, an edge or a face at distance r exactly, every other time; or P or r by ulps");
extern const Family moving_sphere_slide_family = moving_family<sliding_motion<float>, sliding_motion<double>>(
    "moving-sphere/slide", situation::parallel,
    "parallel to the face, over it or beside it, at height r or by ulps not");
extern const Family moving_sphere_skim_family = moving_family<skimming_motion<float>, skimming_motion<double>>(
    "moving-sphere/skim", situation::parallel, "the same with one coordinate of D by up to four ulps from parallel");
extern const Family moving_sphere_along_edge_family =
    moving_family<motion_along_an_edge<float>, motion_along_an_edge<double>>(
        "moving-sphere/along_edge", situation::parallel, "parallel to an edge at distance r from it, or by ulps not");

}  // namespace axiscert::moving_sphere
