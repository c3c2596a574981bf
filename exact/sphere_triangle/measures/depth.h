// The relative distance of a query from the boundary between contact and separation, a number without a unit: by
// rationals, and by integers alone.
#pragma once

#include <optional>

#include "exact/judge/depth.h"
#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// The distance and the depth of a query by integers, rounded once, without CGAL and without rationals.

// The result of depth() for a valid query; empty if the exact depth is a midpoint of two doubles or too near to one.
template <class Real>
std::optional<double> depth_on_grid(const Query<Real>& q);

// The result of rounded_length(exact_depth()), |d - r| in the query's unit, likewise.
template <class Real>
std::optional<double> length_on_grid(const Query<Real>& q);

// The distance from P to the triangle, rounded to nearest: infinite beyond the precision. Empty if it is a midpoint of
// two floats or too near to one. For a valid query, whatever its r.
template <class Real>
std::optional<Real> distance_on_grid(const Query<Real>& q);

// |d - r| / max(|A-P|, |B-P|, |C-P|, r): Euclidean lengths of exact values, with d the exact distance, whose square is
// `squared_distance`; rounded once, to the nearest binary64. 0 if the divisor is 0.
template <class Real>
double depth(const Query<Real>& q, const Rational& squared_distance);

// The same before rounding.
template <class Real>
ExactDepth exact_depth(const Query<Real>& q, const Rational& squared_distance);

// Bounds of the result of depth(), from an enclosure of d; nothing exact is computed. No depth exceeds 1, since d is at
// most |A-P|: the bounds are [0, 1] if no tighter ones are certain.
struct DepthRange {
  double low = 0, high = 1;
};
template <class Real>
DepthRange depth_range(const Query<Real>& q);

template <class Real>
class LazyDistance final : public DepthOf {
 public:
  // The query has to outlive it. `exact_only`: no enclosure and no grid; the results are the same.
  LazyDistance(const Query<Real>& q, bool exact_only) : query_(q), exact_only_(exact_only) {}
  const Rational& squared();
  std::optional<Real> within(const RadiusRange<Real>& range);  // correctly rounded; seldom needs the square
  double at_least() override;
  double at_most() override;
  double exactly() override;
  double length() override;
  double length_at_most() override;
  double engine_threshold() override;
  bool is_touching() override { return is_touching_; }
  void set_touching();

 private:
  const DepthRange& range();

  const Query<Real>& query_;
  bool exact_only_, is_touching_ = false;
  std::optional<Rational> squared_;
  std::optional<Real> rounded_;
  std::optional<DepthRange> range_;
  std::optional<double> depth_;
};

}  // namespace axiscert
