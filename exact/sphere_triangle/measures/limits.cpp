#include "exact/sphere_triangle/measures/limits.h"

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/oracles/area.h"

namespace axiscert {
namespace {

// |V|^2 / 4 >= area^2, V = (B - A) x (C - A).
template <class Real>
bool has_area(const Query<Real>& q, double area) {
  const Vec3<BinaryNumber> normal = exact_normal(q);
  const BinaryNumber twice = BinaryNumber(area) + BinaryNumber(area);
  return portable::dot(normal, normal) >= twice * twice;
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
  return in_range && (limits.least_area == 0 || has_area(q, limits.least_area));
}
template bool is_within<float>(const Limits&, const Query<float>&);
template bool is_within<double>(const Limits&, const Query<double>&);

}  // namespace axiscert
