// The judge of a kernel's separation, normal and points of two bodies: of boxes, of a box and a triangle, and of what
// is made of these.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "exact/boxes/contact.h"
#include "exact/judge/contact_judgement.h"
#include "exact/judge/contact_numbers.h"
#include "kernel/boxes/names.h"

namespace axiscert::boxes {

// `Real` is the precision of the kernel and of the query; `Exact` knows the bodies, as ExactContact does. What is left,
// flips and errors of points are as exact as `Exact` says: of boxes exactly, of a capsule to 2^-229.
template <class Real, class Exact = ExactContact>
class BodyContactJudge final : public ContactJudge {
 public:
  // The exact numbers are found when one is asked for first: beside `separated` most kernels give none.
  explicit BodyContactJudge(std::function<Exact()> find) : find_(std::move(find)) {}

  ContactJudgement judge(Verdict said, std::span<const double> measures) override;
  ContactPlace place() const override;
  double scene() const override { return at_most_finite(nearest_sqrt<double>(exact().squared_scene())); }

 private:
  // A normal whose push leaves more than 1 / most_left, at more than a right angle to every exact one, goes the wrong
  // way.
  static constexpr int most_left = 16;

  const Exact& exact() const {
    if (!exact_) exact_ = find_();
    return *exact_;
  }
  // An overlap is computed to 8 u of the scene, and what is along a normal from centre to centre to 4 u: a normal that
  // is taken for that leaves at most a sixteenth of a depth of 128 u.
  // A capsule's point is r along the normal from its segment's. Where a rounding of the segment makes the normal any
  // direction, so it does of the point, by up to 2 r: |a - b| alone tells then. That holds where the segment touches
  // exactly too: the difference of two nearest points that are rounded is hardly ever 0, and its direction is none.
  bool has_clear_sides() const {
    const Rational clear(mpz_class(1), mpz_class(1) << (std::numeric_limits<Real>::digits - 7));
    return exact().squared_sides() > clear * clear * exact().squared_scene();
  }
  void measure_separation(Verdict said, double separation, ContactJudgement& out) const;
  void measure_normal(const Point& normal, ContactJudgement& out) const;
  void measure_points(const Point& a, const Point& b, ContactJudgement& out) const;

  std::function<Exact()> find_;
  mutable std::optional<Exact> exact_;
};

template <class Real, class Exact>
void BodyContactJudge<Real, Exact>::measure_separation(Verdict said, double separation, ContactJudgement& out) const {
  if (said == Verdict::contact && separation > 0) out.consistency = Consistency::positive;
  if (said == Verdict::separated && separation < 0) out.consistency = Consistency::negative;
  if (sgn(exact().squared_scene()) == 0) return;
  const auto error_from = [&](const Rational& margin) {
    const RootLess right = exact().separation(margin);
    return separation_error<Real>(right.is_negated ? -separation : separation, right.squared, right.less,
                                  exact().squared_scene());
  };
  out.separation = error_from(0);
  if (sgn(margin_) != 0) out.separation_less_margin = error_from(margin_);
}

template <class Real, class Exact>
void BodyContactJudge<Real, Exact>::measure_normal(const Point& normal, ContactJudgement& out) const {
  out.normal_length_error = length_error(normal);
  if (const std::optional<Point> right = exact().only_normal()) out.normal_angle = angle_between(normal, *right);
  if (!exact().is_deep()) return;
  if (sgn(Rational(dot(normal, normal))) == 0) {
    out.pushed = pushed_nowhere();
    return;
  }
  const bool is_backwards =
      std::ranges::all_of(exact().normals(), [&](const Point& right) { return sgn(Rational(dot(normal, right))) < 0; });
  const Decimal6 left = exact().left(normal);
  out.pushed = Pushed{left, is_backwards && has_clear_sides() && axiscert::exact(left) * most_left > 1};
}

// Points of their bodies that a shortest push brings together, or that are as far apart as the bodies, are the exact
// ones where these are the only ones; the normal that is given has no part in it. Their distance from those is no
// figure: of two faces that are parallel but for a rounding it is any.
template <class Real, class Exact>
void BodyContactJudge<Real, Exact>::measure_points(const Point& a, const Point& b, ContactJudgement& out) const {
  out.point_a_error = exact().share_outside_of_a(a);
  out.point_b_error = exact().share_outside_of_b(b);
  out.points_apart = exact().share_of_mismatch(a, b, !has_clear_sides());
}

template <class Real, class Exact>
ContactJudgement BodyContactJudge<Real, Exact>::judge(Verdict said, std::span<const double> measures) {
  ContactJudgement out;
  const auto gives = [&](std::size_t first, std::size_t size) { return measures.size() >= first + size; };
  const bool any_given = std::ranges::any_of(measures, [](double x) { return !std::isnan(x); });
  // Nothing beside `separated` is no fault: axes tell no distance.
  const bool is_asked = any_given || said == Verdict::contact;
  if (gives(separation_measure, 1)) {
    if (any_given) out.consistency = Consistency::consistent;
    if (std::isfinite(measures[separation_measure])) measure_separation(said, measures[separation_measure], out);
    else out.lacks_separation = is_asked;
  }
  if (gives(normal_measure, 3)) {
    if (const auto normal = axiscert::vector_at(measures, normal_measure)) measure_normal(*normal, out);
    else out.lacks_normal = is_asked;
    out.has_right_normal = is_asked && (exact().is_deep() || exact().only_normal());
    out.lacks_push = out.lacks_normal && exact().is_deep();
  }
  if (gives(point_b_measure, 3)) {
    const auto a = axiscert::vector_at(measures, point_a_measure), b = axiscert::vector_at(measures, point_b_measure);
    if (a && b) measure_points(*a, *b, out);
    else out.lacks_point = is_asked;
  }
  const bool lacks = out.lacks_separation || out.lacks_normal || out.lacks_point;
  if (any_given && lacks && out.consistency == Consistency::consistent) out.consistency = Consistency::missing;
  return out;
}

template <class Real, class Exact>
ContactPlace BodyContactJudge<Real, Exact>::place() const {
  ContactPlace out;
  out.separation = exact().rounded_separation();
  if (const auto& points = exact().only_points()) {
    out.point = rounded(points->a);
    out.point_b = rounded(points->b);
  }
  if (const std::optional<Point> normal = exact().only_normal()) out.normal = unit_vector(*normal);
  return out;
}

}  // namespace axiscert::boxes
