#include "exact/sphere_triangle/measures/critical_radius.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/judge/oracles.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/nearest_root.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
namespace {

// |V|^2 / 4 >= area^2, V = (B - A) x (C - A).
template <class Real>
bool has_area(const Query<Real>& q, double area) {
  const Vec3<BinaryNumber> normal = exact_normal(q);
  const BinaryNumber twice = BinaryNumber(area) + BinaryNumber(area);
  return portable::dot(normal, normal) >= twice * twice;
}

// (P - A).V > 0: not so for a triangle without area.
template <class Real>
bool is_in_front(const Query<Real>& q) {
  const auto vec = [](const Vec3<Real>& v) {
    return Vec3<BinaryNumber>{BinaryNumber(double(v.x)), BinaryNumber(double(v.y)), BinaryNumber(double(v.z))};
  };
  return portable::dot(vec(q.p) - vec(q.a), exact_normal(q)).sign() > 0;
}

}  // namespace

template <class Real>
bool is_within(const Limits& limits, const Query<Real>& q) {
  if (!limits.any()) return true;
  // A float widens exactly, so these comparisons are exact.
  const double r = q.r;
  if (r < limits.least_radius || (limits.greatest_radius > 0 && r > limits.greatest_radius)) return false;
  const auto numbers = coordinates(q);
  const bool in_range = std::all_of(numbers.begin(), numbers.end() - 1, [&](Real number) {
    const double x = std::abs(double(number));
    return (x == 0 || x >= limits.least_coordinate) &&
           (limits.greatest_coordinate == 0 || x <= limits.greatest_coordinate);
  });
  if (!in_range || (limits.least_area != 0 && !has_area(q, limits.least_area))) return false;
  // Numbers that are no query have neither a front nor a distance.
  if ((limits.sides == SidesPolicy::both && limits.margin == 0) || !is_valid(q)) return true;
  if (limits.sides == SidesPolicy::front && !is_in_front(q)) return false;
  return limits.margin == 0 || !is_within_margin({squared_distance(q), exact(r)}, limits.margin);
}
template bool is_within<float>(const Limits&, const Query<float>&);
template bool is_within<double>(const Limits&, const Query<double>&);

namespace {

template <class Real>
QueryWithRadius<Real> with_radius_column(const Query<Real>& query) {
  return {query, coordinate_count - 1};
}

}  // namespace

template <class Real>
std::vector<CriticalRadius<Real>> critical_radii(const Implementation<Real>& kernel,
                                                 const std::vector<Query<Real>>& queries,
                                                 const RadiusRange<Real>& range) {
  std::vector<QueryWithRadius<Real>> with_radius;
  with_radius.reserve(queries.size());
  for (const Query<Real>& query : queries) with_radius.push_back(with_radius_column(query));
  return critical_radii(kernel, with_radius, range);
}

template <class Real>
CriticalRadius<Real> critical_radius(const Implementation<Real>& kernel, const Query<Real>& query,
                                     const RadiusRange<Real>& range) {
  return critical_radius(kernel, with_radius_column(query), range);
}

template <class Real>
std::optional<Real> distance_within(const Rational& squared_distance, const RadiusRange<Real>& range) {
  return rounded_distance_within(nearest_sqrt<Real>(squared_distance), range);
}

template <class Real>
Real rounded_distance(const Query<Real>& query) {
  if (const auto found = nearest_distance(query)) return *found;
  const auto found = distance_on_grid(query);
  return found ? *found : nearest_sqrt<Real>(squared_distance(query));
}

template <class Real>
std::optional<Real> rounded_distance_within(Real distance, const RadiusRange<Real>& range) {
  if (!std::isfinite(distance) || distance < range.least || distance > range.greatest) return std::nullopt;
  return distance;
}

template <class Real>
CriticalRadiusError critical_radius_error(const CriticalRadius<Real>& critical, Real distance) {
  if (!critical.answered || critical.not_decided) return {std::nullopt, critical.answered, critical.not_decided};
  if (!critical.radius) return {std::numeric_limits<double>::infinity()};
  return {Rational(abs(exact(*critical.radius) - exact(distance)) / exact(ulp_of(distance))).get_d()};
}

template <class Real>
CriticalRadiusError critical_radius_error(const Implementation<Real>& kernel, const Query<Real>& query,
                                          const Rational& squared_distance, const RadiusRange<Real>& range) {
  const auto distance = distance_within(squared_distance, range);
  return distance ? critical_radius_error(critical_radius(kernel, query, range), *distance) : CriticalRadiusError{};
}

#define AXISCERT_INSTANTIATE(Real)                                                                                     \
  template CriticalRadius<Real> critical_radius(const Implementation<Real>&, const Query<Real>&,                       \
                                                const RadiusRange<Real>&);                                             \
  template std::vector<CriticalRadius<Real>> critical_radii(                                                           \
      const Implementation<Real>&, const std::vector<Query<Real>>&, const RadiusRange<Real>&);                         \
  template std::optional<Real> distance_within(const Rational&, const RadiusRange<Real>&);                             \
  template Real rounded_distance(const Query<Real>&);                                                                  \
  template std::optional<Real> rounded_distance_within(Real, const RadiusRange<Real>&);                                \
  template CriticalRadiusError critical_radius_error(const CriticalRadius<Real>&, Real);                               \
  template CriticalRadiusError critical_radius_error(const Implementation<Real>&, const Query<Real>&, const Rational&, \
                                                     const RadiusRange<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
