#include "fuzz/instruments/critical_distance.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/boxes/box_measures.h"
#include "exact/moving_sphere/least_distance.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/trait/oracles.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

std::optional<Rational> of_sphere_triangle(const Numbers<double>& query) { return squared_distance(query_from(query)); }
// The least distance of the moving centre.
std::optional<Rational> of_moving_sphere(const Numbers<double>& query) {
  return moving_sphere::least_distance(MovingSphere::problem<double>([&](std::size_t k) { return query[k]; })).squared;
}

// The square of the half extent at which two boxes touch.
template <class Boxes>
std::optional<Rational> of_boxes(const Numbers<double>& query) {
  Numbers<double> any = query;
  any[3] = 0;  // the extent that is not read
  if (oracles_of(Boxes::description(), Boxes::entry).truth(any).verdict == Verdict::invalid) return std::nullopt;
  const auto extent =
      boxes::critical_extent(boxes::exact_pair(Boxes::template problem<double>([&](std::size_t k) { return any[k]; })));
  if (!extent) return std::nullopt;
  return Rational(*extent * *extent);
}

// The first length of a query.
std::size_t radius_column(const TestEntry& entry) {
  const std::vector<TestColumn>& columns = entry.columns;
  const auto is_length = [](const TestColumn& column) { return column.role == Role::length; };
  return static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(), is_length) - columns.begin());
}

}  // namespace

std::vector<const TestDescription*> tests_with_critical_distance() {
  return {&sphere_triangle_test(), &moving_sphere_test(), &box_box_test()};
}

bool has_sphere_radius(const TestDescription& test, std::size_t entry) {
  const std::vector<const TestDescription*> with_distance = tests_with_critical_distance();
  if (entry != 0 || std::find(with_distance.begin(), with_distance.end(), &test) == with_distance.end()) return false;
  return test.entries[0].columns[critical_distance_of(test).radius].name == "r";
}

CriticalDistance critical_distance_of(const TestDescription& test, std::size_t entry) {
  const std::size_t radius = radius_column(test.entries[entry]);
  if (&test == &sphere_triangle_test()) return {test, radius, of_sphere_triangle};
  if (&test == &moving_sphere_test()) return {test, radius, of_moving_sphere};
  if (&test == &box_box_test() && entry == boxes::MatrixBoxes::entry)
    return {test, radius, of_boxes<boxes::MatrixBoxes>};
  if (&test == &box_box_test()) return {test, radius, of_boxes<boxes::QuaternionBoxes>};
  throw HarnessFault(fmt::format("{} has no critical radius", test.id));
}

}  // namespace axiscert
