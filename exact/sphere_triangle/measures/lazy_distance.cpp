#include "exact/sphere_triangle/measures/lazy_distance.h"

#include <limits>

#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {

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
void LazyDistance<Real>::set_touching() {
  is_touching_ = true;
  if (exact_only_) return;
  range_ = DepthRange{0, 0};
  depth_ = 0;
}
template class LazyDistance<float>;
template class LazyDistance<double>;

}  // namespace axiscert
