#include "exact/sphere_triangle/measures/lazy_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
namespace {

// The divisor of the depth, max(|A-P|, |B-P|, |C-P|, r), but for roundings: vectors over their greatest component, so
// that no square overflows, and one that underflows is far below the sum, which is at least 1.
template <class Real>
double scene_at_most(const Query<Real>& q) {
  const Query<double>& wide = widened(q);
  double greatest = wide.r;
  for (const Vec3<double>* vertex : {&wide.a, &wide.b, &wide.c}) {
    const Vec3<double> v = *vertex - wide.p;
    const double size = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (size == 0) continue;
    if (!std::isfinite(size)) return size;
    const double x = v.x / size, y = v.y / size, z = v.z / size;
    greatest = std::max(greatest, std::sqrt(x * x + y * y + z * z) * size);
  }
  return greatest;
}

}  // namespace

template <class Real>
const Rational& LazyDistance<Real>::squared() {
  if (!squared_) squared_ = squared_distance(query_);
  return *squared_;
}
template <class Real>
std::optional<Real> LazyDistance<Real>::within(const RadiusRange<Real>& range) {
  if (exact_only_) return distance_within(squared(), range);
  if (!rounded_) rounded_ = rounded_distance(query_);
  return rounded_distance_within(*rounded_, range);
}
template <class Real>
const DepthRange& LazyDistance<Real>::range() {
  if (!range_) range_ = exact_only_ ? DepthRange{exactly(), exactly()} : depth_range(query_);
  return *range_;
}
template <class Real>
double LazyDistance<Real>::at_least() {
  return range().low;
}
template <class Real>
double LazyDistance<Real>::at_most() {
  return range().high;
}
template <class Real>
double LazyDistance<Real>::engine_threshold() {
  return is_engine_like(query_) ? engine_depth<Real> : std::numeric_limits<double>::infinity();
}
template <class Real>
double LazyDistance<Real>::exactly() {
  if (!depth_ && !exact_only_) depth_ = depth_on_grid(query_);
  if (!depth_) depth_ = depth(query_, squared());
  return *depth_;
}
template <class Real>
double LazyDistance<Real>::length() {
  if (is_touching_) return 0;
  const std::optional<double> by_integers = exact_only_ ? std::nullopt : length_on_grid(query_);
  return by_integers ? *by_integers : rounded_length(exact_depth(query_, squared()));
}
template <class Real>
double LazyDistance<Real>::length_at_most() {
  if (is_touching_) return 0;
  // Twelve roundings at most, each of 2^-53 or less; where numbers are subnormal the terms that are added, the first
  // for the rounding of the depth.
  return (at_most() + 0x1p-1074) * scene_at_most(query_) * (1 + 0x1p-48) + 0x1p-1070;
}
template <class Real>
void LazyDistance<Real>::set_touching() {
  is_touching_ = true;
  if (exact_only_) return;
  range_ = DepthRange{0, 0};
  depth_ = 0;
}
template class LazyDistance<float>;
template class LazyDistance<double>;

}  // namespace axiscert
