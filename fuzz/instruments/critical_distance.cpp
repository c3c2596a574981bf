#include "fuzz/instruments/critical_distance.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/moving_sphere/least_distance.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

Rational of_sphere_triangle(const Numbers<double>& query) { return squared_distance(query_from(query)); }
// The least distance of the moving centre.
Rational of_moving_sphere(const Numbers<double>& query) {
  return moving_sphere::least_distance(MovingSphere::problem<double>([&](std::size_t k) { return query[k]; })).squared;
}

// The one length of a query.
std::size_t radius_column(const TestDescription& test) {
  const std::vector<TestColumn>& columns = test.entries[0].columns;
  const auto is_length = [](const TestColumn& column) { return column.role == Role::length; };
  return static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(), is_length) - columns.begin());
}

}  // namespace

std::vector<const TestDescription*> tests_with_critical_distance() {
  return {&sphere_triangle_test(), &moving_sphere_test()};
}

CriticalDistance critical_distance_of(const TestDescription& test) {
  if (&test == &sphere_triangle_test()) return {test, radius_column(test), of_sphere_triangle};
  if (&test == &moving_sphere_test()) return {test, radius_column(test), of_moving_sphere};
  throw HarnessFault(fmt::format("{} has no critical radius", test.id));
}

}  // namespace axiscert
