#include "exact/sphere_triangle/measures/lazy_distance.h"

#include <algorithm>
#include <cmath>
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
double LazyDistance<Real>::length() {
  return is_touching_ ? 0 : rounded_length(exact_depth(query_, squared()));
}
template <class Real>
double LazyDistance<Real>::length_at_most() {
  // The scene is r, or a vertex away from P: at most sqrt(3) times the greatest difference of coordinates. The three
  // roundings, each of 2^-53 or less, and that of the depth are far below what 1.8 leaves.
  double greatest = std::fabs(static_cast<double>(query_.r));
  const auto apart = [](Real x, Real y) { return std::fabs(static_cast<double>(x) - static_cast<double>(y)); };
  for (const Vec3<Real>* v : {&query_.a, &query_.b, &query_.c})
    greatest = std::max({greatest, apart(v->x, query_.p.x), apart(v->y, query_.p.y), apart(v->z, query_.p.z)});
  return is_touching_ ? 0 : at_most() * greatest * 1.8 + std::numeric_limits<double>::denorm_min();
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
