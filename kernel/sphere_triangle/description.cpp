#include "kernel/sphere_triangle/description.h"

#include "kernel/sphere_triangle/names.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/test.h"

namespace axiscert {
namespace {

// "ax", "ay" and "az" form the group "a", a vertex; "r" is a group of its own.
TestEntry vertices() {
  TestEntry entry{"vertices", "every number finite, the radius not negative; -0 is 0", {}};
  for (const std::string_view name : coordinate_names) {
    entry.columns.push_back({name, name == "r" ? Role::length : Role::coordinate, name.substr(0, 1)});
  }
  entry.shared_columns = 9;  // the triangle
  return entry;
}

TestDescription described() {
  TestDescription test{
      .id = "sphere-triangle",
      .asks = "does a closed solid sphere have a point in common with a closed triangle",
      .touching = "the distance from the centre to the triangle is exactly the radius",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {vertices()},
      .comparisons = {},
      .clauses = {},
      .measures = {},
      .certified = "certified",
      .usual_formulae = "published",
      .has_strictness = true,
      .is_implied = true,
  };
  for (const ComparisonInfo& comparison : comparisons) {
    test.comparisons.push_back({comparison.name, index_of(comparison.axis), comparison.is_radius});
  }
  for (std::size_t i = 0; i < axis_count; ++i) test.clauses.push_back({axis_names[i], axis_comparisons[i]});
  return checked(std::move(test));
}

}  // namespace

const TestDescription& sphere_triangle_test() {
  static const TestDescription test = described();
  return test;
}

}  // namespace axiscert
