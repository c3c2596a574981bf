// Motions whose least distance is r exactly, or by ulps not: in the plane n.(Z - X) = r r.
#include "fuzz/moving_sphere/parts.h"

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

// Motions that meet, or leave, a feature at a known time: the centre is then at X + n.

namespace {

template <class Real>
Numbers<Real> touching_at_the_end(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  const std::int64_t length = random.integer(1, 4);
  const Whole d = against(random, t.normal) * length;
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal - d, d, t.r);
  nudge(random, position, q);
  return q;
}

template <class Real>
Numbers<Real> touching_at_the_start(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  const std::int64_t length = random.integer(1, 4);
  const Whole d = Whole{0, 0, 0} - against(random, t.normal) * length;
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal, d, t.r);
  nudge(random, position, q);
  return q;
}

// D = k d reaches X + n at the time s / k exactly: within the motion, at its end, or just not.
template <class Real>
Numbers<Real> touching_on_the_way(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  const Whole d = against(random, t.normal);
  const std::int64_t k = random.integer(2, 8), s = random.integer(1, k + 1);
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal - d * s, d * k, t.r);
  nudge(random, position, q);
  return q;
}

// n is at right angles to an edge at the vertex X: the regions of vertex and edge meet there. Every third time the edge
// goes both ways, and in the face's turn n is the normal and X a vertex, where three regions meet.
template <class Real>
Numbers<Real> meeting_a_seam(Stream& random, std::uint64_t position) {
  TouchedTriangle t = touched(random, FeatureKind::vertex);
  t.vertex = {t.at, t.at + t.along, t.at + behind(random, t.normal)};
  if (position % 3 == 2) t.vertex[2] = t.at + cross(t.normal, t.along);
  t.vertex = shapes::shuffled(random, t.vertex);
  const Whole d = against(random, t.normal);
  const std::int64_t k = random.integer(1, 4), s = random.integer(1, k);
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal - d * s, d * k, t.r);
  nudge(random, position, q);
  return q;
}

// The radius within four ulps of the distance at the start; inwards, outwards, along the surface.
template <class Real>
Numbers<Real> overlap_by_ulps(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  const Whole in = against(random, t.normal);
  const std::uint64_t way = position / 3 % 3;
  const Whole d = way == 0 ? in : way == 1 ? Whole{0, 0, 0} - in : across(random, t.normal);
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at + t.normal, d, t.r);
  q.r = step_radius(q.r, static_cast<int>(position / 9 % 9) - 4);
  return q;
}

// A ray, or a needle, through a vertex, an edge or the face's inside.
template <class Real>
Numbers<Real> moving_point(Stream& random, std::uint64_t position) {
  const TouchedTriangle t = touched(random, feature_in_turn(position));
  const Whole d = shapes::integers(random, 20);
  const std::int64_t k = random.integer(1, 4), s = random.integer(0, k);
  MovingQuery<Real> q = spread<Real>(random, t.vertex, t.at - d * s, d * k, 0);
  nudge(random, position, q);
  if (position / 12 % 2 == 1) q.r = std::ldexp(random.unit<Real>(), -20);
  return q;
}

}  // namespace

extern const Family moving_sphere_touch_end_family =
    moving_family<touching_at_the_end<float>, touching_at_the_end<double>>(
        "moving-sphere/touch_end", situation::touching,
        "touches at the end of the motion, every other time; or P or r by ulps");
extern const Family moving_sphere_touch_start_family =
    moving_family<touching_at_the_start<float>, touching_at_the_start<double>>(
        "moving-sphere/touch_start", situation::touching,
        "touches at the start and leaves, every other time; or P or r by ulps");
extern const Family moving_sphere_exact_time_family =
    moving_family<touching_on_the_way<float>, touching_on_the_way<double>>(
        "moving-sphere/exact_time", situation::touching,
        "would first touch at 1 / 8 to 3 / 2 of the way exactly, every other time; or P or r by ulps");
extern const Family moving_sphere_seam_time_family = moving_family<meeting_a_seam<float>, meeting_a_seam<double>>(
    "moving-sphere/seam_time", situation::touching,
    "meets a vertex where the region of an edge, or of the face too, begins");
extern const Family moving_sphere_overlap_ulp_family = moving_family<overlap_by_ulps<float>, overlap_by_ulps<double>>(
    "moving-sphere/overlap_ulp", situation::touching,
    "overlaps, touches or misses at the start by ulps; inwards, outwards, along");
extern const Family moving_sphere_point_family = moving_family<moving_point<float>, moving_point<double>>(
    "moving-sphere/point", situation::point, "r = 0 or tiny, through a vertex, an edge, the inside of the face");

}  // namespace axiscert::moving_sphere
