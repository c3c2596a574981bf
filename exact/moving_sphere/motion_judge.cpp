#include "exact/moving_sphere/motion_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/judge/contact_numbers.h"
#include "exact/moving_sphere/first_contact.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert::moving_sphere {
namespace {

using portable::dot;

// The squared distance at a time of the piece, in squares of the motion's unit.
Rational squared_at(const Piece& piece, const Rational& t) {
  return ((piece.a * t - 2 * piece.b) * t + piece.c) / piece.divisor;
}

RationalVector in_units_of(const RationalVector& v, int exponent) {
  return {times_power(v.x, exponent), times_power(v.y, exponent), times_power(v.z, exponent)};
}

template <class Real>
Rational next_above(double time) {
  return exact(std::nextafter(static_cast<Real>(time), std::numeric_limits<Real>::infinity()));
}

}  // namespace

template <class Real>
FirstContactJudge<Real>::FirstContactJudge(const GivenMotion& q)
    : q_(q), motion_(q), contact_(first_contact(q, motion_).value()), r_(exact(q.r)), scene_(squared_scene(q)) {}

template <class Real>
Rational FirstContactJudge<Real>::least_squared(const Rational& until) const {
  std::optional<Rational> least;
  for (const Piece& piece : motion_.pieces) {
    if (piece.first > until) continue;
    const Rational last = std::min(piece.last, until);
    // A parabola that is nowhere negative is least at b / a, or at the end that is nearer to it.
    const Rational at = piece.a == 0 ? piece.first : std::max(piece.first, std::min(last, quotient(piece.b, piece.a)));
    Rational squared = squared_at(piece, at);
    if (!least || squared < *least) least = std::move(squared);
  }
  return times_power(*least, 2 * motion_.exponent);
}

template <class Real>
Rational FirstContactJudge<Real>::squared_distance(const Rational& at) const {
  for (const Piece& piece : motion_.pieces) {
    if (piece.first <= at && at <= piece.last) return times_power(squared_at(piece, at), 2 * motion_.exponent);
  }
  return {};  // not reached: the pieces cover [0, 1]
}

template <class Real>
TimeVerdict FirstContactJudge<Real>::time_verdict(double time) const {
  if (std::isnan(time)) return TimeVerdict::none;
  if (!(time >= 0 && time <= 1)) return TimeVerdict::invalid;
  if (compare(contact_.time, exact(time)) < 0) return TimeVerdict::late;
  return compare(contact_.time, next_above<Real>(time)) < 0 ? TimeVerdict::best : TimeVerdict::early;
}

template <class Real>
void FirstContactJudge<Real>::measure_time(double time, ContactJudgement& out) const {
  out.time = time_verdict(time);
  if (out.time != TimeVerdict::early && out.time != TimeVerdict::late) return;
  const Rational t = exact(time), error = apart(contact_.time, t);
  const auto best = static_cast<double>(rounded_down<Real>(contact_.time));
  out.ulps = round_up(Rational(error / (next_above<Real>(best) - exact(best))));
  out.in_u = round_up(times_power(error, std::numeric_limits<Real>::digits));
  out.share = rounded_apart(contact_.time, t, error, 1);
  out.length =
      rounded_apart(contact_.time, t, error, times_power(Rational(dot(motion_.d, motion_.d)), 2 * motion_.exponent));
  if (out.time == TimeVerdict::late) out.tunnel = tunnel_of(r_, least_squared(t));
  else if (sgn(scene_) != 0) out.gap = rounded_depth({squared_distance(t), r_, scene_});
}

template <class Real>
auto FirstContactJudge<Real>::found_place() const -> Place {
  const Rational t = approximate(contact_.time);
  const MovingPoint nearest = nearest_point(motion_, *contact_.features.begin());
  const RationalVector centre = rationals(motion_.d) * t, point = nearest.from + nearest.along * t;
  return {point, centre - point};
}

template <class Real>
RationalVector FirstContactJudge<Real>::exact_centre() const {
  return {exact(q_.p.x), exact(q_.p.y), exact(q_.p.z)};
}

template <class Real>
ContactPlace FirstContactJudge<Real>::place() const {
  const Place here = place_ ? *place_ : found_place();
  ContactPlace out;
  out.after_best = nearest<double>(apart(contact_.time, exact(rounded_down<Real>(contact_.time))));
  out.point = rounded(exact_centre() + in_units_of(here.point, motion_.exponent));
  out.from_a = rounded(in_units_of(here.point - rationals(motion_.vertex[0]), motion_.exponent));
  if (sgn(dot(here.to_centre, here.to_centre)) != 0) out.normal = unit_vector(here.to_centre);
  return out;
}

template <class Real>
auto FirstContactJudge<Real>::known_place() -> const Place& {
  if (!place_) place_ = found_place();
  return *place_;
}

template <class Real>
void FirstContactJudge<Real>::measure_feature(double number, ContactJudgement& out) {
  if (std::isnan(number)) {
    out.lacks_feature = contact_.start != Start::overlap;
    return;
  }
  const std::optional<std::size_t> named = part_named(number);
  out.feature_is_right = named && contact_.features.contains(static_cast<Feature>(*named));
  if (*out.feature_is_right) return;
  out.feature_error = 0;
  if (!named) out.feature_error = std::numeric_limits<double>::infinity();
  else if (sgn(scene_) != 0) {
    const Place& here = known_place();
    const Rational beyond = squared_beyond(
        *named, {rationals(motion_.vertex[0]), rationals(motion_.vertex[1]), rationals(motion_.vertex[2])},
        here.point + here.to_centre);
    out.feature_error = nearest_sqrt<double>(Rational(times_power(beyond, 2 * motion_.exponent) / scene_));
  }
}

template <class Real>
void FirstContactJudge<Real>::measure_place(std::span<const double> measures, ContactJudgement& out) {
  const bool gives_normal = measures.size() >= normal_measure + 3, gives_point = measures.size() >= point_measure + 3;
  if (!gives_normal && !gives_point) return;
  const std::optional<RationalVector> normal = vector_at(measures, normal_measure),
                                      point = vector_at(measures, point_measure);
  const Place& here = known_place();
  const bool is_overlap = contact_.start == Start::overlap, has_normal = sgn(dot(here.to_centre, here.to_centre)) != 0;
  out.lacks_normal = gives_normal && !normal && has_normal && !is_overlap;
  out.has_right_normal = has_normal && (normal || !is_overlap);
  out.lacks_point = gives_point && !point && !is_overlap;
  if (normal && has_normal) {
    out.normal_angle = angle_between(*normal, here.to_centre);
    out.normal_length_error = length_error(*normal);
  }
  if (!point || sgn(scene_) == 0) return;
  const RationalVector off = *point - exact_centre() - in_units_of(here.point, motion_.exponent);
  const double error = nearest_sqrt<double>(Rational(dot(off, off) / scene_));
  out.point_error = std::min(error, std::numeric_limits<double>::max());
}

template <class Real>
ContactJudgement FirstContactJudge<Real>::judge(Verdict said, std::span<const double> measures) {
  ContactJudgement out;
  if (said == Verdict::separated) {
    out.missed = tunnel_of(r_, least_squared(1));
    return out;
  }
  if (measures.size() > time_measure) measure_time(measures[time_measure], out);
  if (measures.size() > feature_measure) measure_feature(measures[feature_measure], out);
  measure_place(measures, out);
  return out;
}

template <class Real>
double FirstContactJudge<Real>::scene() const {
  return nearest_sqrt<double>(scene_);
}

template class FirstContactJudge<float>;
template class FirstContactJudge<double>;

}  // namespace axiscert::moving_sphere
