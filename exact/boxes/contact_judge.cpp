#include "exact/boxes/contact_judge.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/judge/contact_numbers.h"
#include "exact/numbers/root_number.h"
#include "kernel/boxes/names.h"

namespace axiscert::boxes {
namespace {

// A normal whose push leaves more than this, at more than a right angle to every exact one, goes the wrong way.
const Rational most_left_of_no_flip(1, 16);

double at_most_finite(double x) { return std::min(x, std::numeric_limits<double>::max()); }

// sqrt(square / scene), and 0 of two points in one place.
double share_of(const Rational& square, const Rational& scene) {
  return sgn(scene) == 0 ? 0 : at_most_finite(nearest_sqrt<double>(Rational(square / scene)));
}

}  // namespace

template <class Real>
const ExactContact& BoxContactJudge<Real>::exact() const {
  if (!exact_) exact_ = find_();
  return *exact_;
}

template <class Real>
void BoxContactJudge<Real>::measure_separation(Verdict said, double separation, ContactJudgement& out) const {
  if (said == Verdict::contact && separation > 0) out.consistency = Consistency::positive;
  if (said == Verdict::separated && separation < 0) out.consistency = Consistency::negative;
  if (sgn(exact().squared_scene()) == 0) return;
  // In a penetration both signs are turned round, and the error is the same.
  const double towards = exact().is_apart() ? separation : -separation;
  const auto error_from = [&](const Rational& less) {
    return separation_error<Real>(towards, exact().squared_separation(), less, exact().squared_scene());
  };
  out.separation = error_from(0);
  if (sgn(margin_) != 0) out.separation_less_margin = error_from(exact().is_apart() ? margin_ : Rational(-margin_));
}

template <class Real>
void BoxContactJudge<Real>::measure_normal(const Point& normal, ContactJudgement& out) const {
  out.normal_length_error = length_error(normal);
  if (const std::optional<Point> right = exact().only_normal()) out.normal_angle = angle_between(normal, *right);
  if (exact().is_apart() || exact().squared_separation() == 0 || sgn(Rational(dot(normal, normal))) == 0) return;
  const bool is_backwards =
      std::ranges::all_of(exact().normals(), [&](const Point& right) { return sgn(Rational(dot(normal, right))) < 0; });
  // An overlap is computed to 8 u of the scene, and what is along a normal from centre to centre to 4 u: a normal that
  // is taken for that leaves at most a sixteenth of a depth of 128 u.
  const Rational clear(mpz_class(1), mpz_class(1) << (std::numeric_limits<Real>::digits - 7));
  const bool is_clear = exact().squared_separation() > clear * clear * exact().squared_scene();
  out.pushed =
      Pushed{exact().left(normal), is_backwards && is_clear && exact().compare_left(normal, most_left_of_no_flip) > 0};
}

// Points of their bodies that are as far apart as the separation, along the normal, are the exact ones where these are
// the only ones. Their distance from those is no figure: of two faces that are parallel but for a rounding it is any.
template <class Real>
void BoxContactJudge<Real>::measure_points(const Point& a, const Point& b, const std::optional<Point>& normal,
                                           ContactJudgement& out) const {
  const Rational& scene = exact().squared_scene();
  out.point_a_error = share_of(exact().squared_distance_from_a(a), scene);
  out.point_b_error = share_of(exact().squared_distance_from_b(b), scene);
  const int along = normal ? sgn(Rational(dot(b - a, *normal))) : 0;
  const Rational mismatch = exact().mismatch(a, b, along == (exact().is_apart() ? -1 : 1));
  out.points_apart = share_of(Rational(mismatch * mismatch), scene);
}

template <class Real>
ContactJudgement BoxContactJudge<Real>::judge(Verdict said, std::span<const double> measures) {
  ContactJudgement out;
  const auto gives = [&](std::size_t first, std::size_t size) { return measures.size() >= first + size; };
  const bool any_given = std::ranges::any_of(measures, [](double x) { return !std::isnan(x); });
  // Nothing beside `separated` is no fault: axes tell no distance.
  const bool is_asked = any_given || said == Verdict::contact;
  if (gives(separation_measure, 1)) {
    out.consistency = Consistency::consistent;
    if (std::isfinite(measures[separation_measure])) measure_separation(said, measures[separation_measure], out);
    else out.lacks_separation = is_asked;
  }
  std::optional<Point> normal;
  if (gives(normal_measure, 3)) {
    normal = axiscert::vector_at(measures, normal_measure);
    if (normal) measure_normal(*normal, out);
    else out.lacks_normal = is_asked;
  }
  if (gives(point_b_measure, 3)) {
    const auto a = axiscert::vector_at(measures, point_a_measure), b = axiscert::vector_at(measures, point_b_measure);
    if (a && b) measure_points(*a, *b, normal, out);
    else out.lacks_point = is_asked;
  }
  const bool lacks = out.lacks_separation || out.lacks_normal || out.lacks_point;
  if (any_given && lacks && out.consistency == Consistency::consistent) out.consistency = Consistency::missing;
  return out;
}

template <class Real>
ContactPlace BoxContactJudge<Real>::place() const {
  ContactPlace out;
  const double size = at_most_finite(nearest_sqrt<double>(exact().squared_separation()));
  out.separation = exact().is_apart() || size == 0 ? size : -size;
  if (exact().only_points()) {
    out.point = rounded(exact().only_points()->a);
    out.point_b = rounded(exact().only_points()->b);
  }
  if (const std::optional<Point> normal = exact().only_normal()) out.normal = unit_vector(*normal);
  return out;
}

template <class Real>
double BoxContactJudge<Real>::scene() const {
  return at_most_finite(nearest_sqrt<double>(exact().squared_scene()));
}

template class BoxContactJudge<float>;
template class BoxContactJudge<double>;

}  // namespace axiscert::boxes
