// The exact squared distance of one query and its depth, each found when it is first asked for: few queries need them.
#pragma once

#include <optional>

#include "exact/judge/depth.h"
#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/measures/depth.h"

namespace axiscert {

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
