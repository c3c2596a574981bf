#include "exact/moving_sphere/motion_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/moving_sphere/first_contact.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert::moving_sphere {
namespace {

using RationalVector = portable::Vec3<Rational>;
using portable::dot;

// The squared distance at a time of the piece, in squares of the motion's unit.
Rational squared_at(const Piece& piece, const Rational& t) {
  return ((piece.a * t - 2 * piece.b) * t + piece.c) / piece.divisor;
}

RationalVector in_units_of(const RationalVector& v, int exponent) {
  return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
}

std::array<double, 3> rounded(const RationalVector& v) {
  return {nearest<double>(v.x), nearest<double>(v.y), nearest<double>(v.z)};
}
// v / |v|, for a v that is not zero.
std::array<double, 3> unit_vector(const RationalVector& v) {
  const Rational squared = dot(v, v);
  const auto share = [&](const Rational& x) {
    const double size = nearest_sqrt<double>(Rational(x * x / squared));
    return sgn(x) < 0 ? -size : size;
  };
  return {share(v.x), share(v.y), share(v.z)};
}

std::optional<RationalVector> vector_at(std::span<const double> measures, std::size_t first) {
  if (measures.size() < first + 3) return std::nullopt;
  const auto is_finite = [](double x) { return std::isfinite(x); };
  if (!std::all_of(measures.begin() + static_cast<std::ptrdiff_t>(first),
                   measures.begin() + static_cast<std::ptrdiff_t>(first + 3), is_finite)) {
    return std::nullopt;
  }
  return RationalVector{exact(measures[first]), exact(measures[first + 1]), exact(measures[first + 2])};
}

// The part that a number names; empty where it names none.
std::optional<Feature> feature_named(double number) {
  for (const Feature one : enumerators<Feature>) {
    if (number == static_cast<double>(index_of(one))) return one;
  }
  return std::nullopt;
}

// The square of how far a point is along a direction, per unit; 0 where it is behind, or there is no direction.
Rational squared_along(const RationalVector& at, const RationalVector& direction) {
  const Rational along = dot(at, direction);
  if (sgn(along) <= 0) return 0;
  return along * along / dot(direction, direction);
}

template <class Real>
Rational next_above(double time) {
  return exact(std::nextafter(static_cast<Real>(time), std::numeric_limits<Real>::infinity()));
}

}  // namespace

template <class Real>
ContactJudge<Real>::ContactJudge(const GivenMotion& q)
    : q_(q), motion_(q), contact_(first_contact(q, motion_).value()), r_(exact(q.r)), scene_(squared_scene(q)) {}

template <class Real>
Rational ContactJudge<Real>::least_squared(const Rational& until) const {
  std::optional<Rational> least;
  for (const Piece& piece : motion_.pieces) {
    if (piece.first > until) continue;
    const Rational last = std::min(piece.last, until);
    // A parabola that is nowhere negative is least at b / a, or at the end that is nearer to it.
    const Rational at = piece.a == 0 ? piece.first : std::max(piece.first, std::min(last, quotient(piece.b, piece.a)));
    Rational squared = squared_at(piece, at);
    if (!least || squared < *least) least = std::move(squared);
  }
  return scaled(*least, 2 * motion_.exponent);
}

template <class Real>
Rational ContactJudge<Real>::squared_distance(const Rational& at) const {
  for (const Piece& piece : motion_.pieces) {
    if (piece.first <= at && at <= piece.last) return scaled(squared_at(piece, at), 2 * motion_.exponent);
  }
  return {};  // not reached: the pieces cover [0, 1]
}

template <class Real>
TimeVerdict ContactJudge<Real>::time_verdict(double time) const {
  if (std::isnan(time)) return TimeVerdict::none;
  if (!(time >= 0 && time <= 1)) return TimeVerdict::invalid;
  if (compare(contact_.time, exact(time)) < 0) return TimeVerdict::late;
  return compare(contact_.time, next_above<Real>(time)) < 0 ? TimeVerdict::best : TimeVerdict::early;
}

template <class Real>
void ContactJudge<Real>::measure_time(double time, MotionJudgement& out) const {
  out.time = time_verdict(time);
  if (out.time != TimeVerdict::early && out.time != TimeVerdict::late) return;
  const Rational t = exact(time), error = apart(contact_.time, t);
  const auto best = static_cast<double>(rounded_down<Real>(contact_.time));
  out.ulps = round_up(Rational(error / (next_above<Real>(best) - exact(best))));
  out.in_u = round_up(scaled(error, std::numeric_limits<Real>::digits));
  out.share = rounded_apart(contact_.time, t, error, 1);
  out.length =
      rounded_apart(contact_.time, t, error, scaled(Rational(dot(motion_.d, motion_.d)), 2 * motion_.exponent));
  if (out.time == TimeVerdict::late) out.tunnel = tunnel_of(r_, least_squared(t));
  else if (sgn(scene_) != 0) out.gap = rounded_depth({squared_distance(t), r_, scene_});
}

template <class Real>
auto ContactJudge<Real>::place() const -> Place {
  const Rational t = approximate(contact_.time);
  const MovingPoint nearest = nearest_point(motion_, *contact_.features.begin());
  const RationalVector centre = rationals(motion_.d) * t, point = nearest.from + nearest.along * t;
  return {point, centre - point};
}

template <class Real>
RationalVector ContactJudge<Real>::exact_centre() const {
  return {exact(q_.p.x), exact(q_.p.y), exact(q_.p.z)};
}

template <class Real>
ContactPlace ContactJudge<Real>::first() const {
  const Place here = place_ ? *place_ : place();
  ContactPlace out;
  out.after_best = nearest<double>(apart(contact_.time, exact(rounded_down<Real>(contact_.time))));
  out.point = rounded(exact_centre() + in_units_of(here.point, motion_.exponent));
  out.from_a = rounded(in_units_of(here.point - rationals(motion_.vertex[0]), motion_.exponent));
  if (sgn(dot(here.to_centre, here.to_centre)) != 0) out.normal = unit_vector(here.to_centre);
  return out;
}

template <class Real>
auto ContactJudge<Real>::known_place() -> const Place& {
  if (!place_) place_ = place();
  return *place_;
}

// A region of a triangle is where the centre is beyond the ends of the edges at a vertex; beside an edge, outside;
// above or below the face.
template <class Real>
Rational ContactJudge<Real>::squared_beyond(Feature feature) {
  const Place& here = known_place();
  const RationalVector centre = here.point + here.to_centre, normal = rationals(motion_.normal);
  const auto vertex = [&](std::size_t i) { return rationals(motion_.vertex[i % 3]); };
  const std::size_t i = index_of(feature);
  if (i < index_of(Feature::edge_ab)) {
    const RationalVector at = centre - vertex(i);
    return std::max(squared_along(at, vertex(i + 1) - vertex(i)), squared_along(at, vertex(i + 2) - vertex(i)));
  }
  const auto outwards = [&](std::size_t k) { return cross(vertex(k + 1) - vertex(k), normal); };
  Rational most = 0;
  if (feature == Feature::face) {
    for (const std::size_t k : {0u, 1u, 2u}) most = std::max(most, squared_along(centre - vertex(k), outwards(k)));
    return most;
  }
  const RationalVector along = vertex(i + 1) - vertex(i);
  most = std::max(squared_along(centre - vertex(i + 1), along), squared_along(vertex(i) - centre, along));
  return std::max(most, squared_along(vertex(i) - centre, outwards(i)));
}

template <class Real>
void ContactJudge<Real>::measure_feature(double number, MotionJudgement& out) {
  if (std::isnan(number)) {
    out.lacks_feature = contact_.start != Start::overlap;
    return;
  }
  const std::optional<Feature> named = feature_named(number);
  out.feature_is_right = named && contact_.features.contains(*named);
  if (*out.feature_is_right) return;
  out.feature_error = 0;
  if (!named) out.feature_error = std::numeric_limits<double>::infinity();
  else if (sgn(scene_) != 0) {
    out.feature_error = nearest_sqrt<double>(Rational(scaled(squared_beyond(*named), 2 * motion_.exponent) / scene_));
  }
}

template <class Real>
void ContactJudge<Real>::measure_place(std::span<const double> measures, MotionJudgement& out) {
  const bool gives_normal = measures.size() >= normal_measure + 3, gives_point = measures.size() >= point_measure + 3;
  if (!gives_normal && !gives_point) return;
  const std::optional<RationalVector> normal = vector_at(measures, normal_measure),
                                      point = vector_at(measures, point_measure);
  const Place& here = known_place();
  const bool is_overlap = contact_.start == Start::overlap, has_normal = sgn(dot(here.to_centre, here.to_centre)) != 0;
  out.lacks_normal = gives_normal && !normal && has_normal && !is_overlap;
  out.lacks_point = gives_point && !point && !is_overlap;
  if (normal && has_normal) {
    out.normal_angle = angle_between(*normal, here.to_centre);
    // Without a difference of roots: (n.n - 1) / (|n| + 1).
    const Rational squared = dot(*normal, *normal);
    out.normal_length_error =
        std::min(nearest<double>(Rational(abs(Rational(squared - 1)) / (root_below(squared) + 1))),
                 std::numeric_limits<double>::max());
  }
  if (!point || sgn(scene_) == 0) return;
  const RationalVector off = *point - exact_centre() - in_units_of(here.point, motion_.exponent);
  const double error = nearest_sqrt<double>(Rational(dot(off, off) / scene_));
  out.point_error = std::min(error, std::numeric_limits<double>::max());
}

template <class Real>
MotionJudgement ContactJudge<Real>::judge_hit(std::span<const double> measures) {
  MotionJudgement out;
  if (measures.size() > time_measure) measure_time(measures[time_measure], out);
  if (measures.size() > feature_measure) measure_feature(measures[feature_measure], out);
  measure_place(measures, out);
  return out;
}

template <class Real>
Tunnel ContactJudge<Real>::judge_miss() {
  return tunnel_of(r_, least_squared(1));
}

template class ContactJudge<float>;
template class ContactJudge<double>;

}  // namespace axiscert::moving_sphere
