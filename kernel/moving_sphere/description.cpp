#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert {
namespace {

TestDescription moving_sphere_described() {
  constexpr Role place = Role::coordinate, direction = Role::direction;
  TestDescription test{
      .id = "moving-sphere",
      .asks = "does a closed solid sphere that moves along a line have a point in common with a closed triangle",
      .touching =
          "the least distance from the moving centre to the triangle is exactly the radius, unless a point (r = 0) "
          "crosses the inside of the face",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"displacement",
                   "every number finite, the radius not negative; -0 is 0",
                   {{"ax", place, "a"},
                    {"ay", place, "a"},
                    {"az", place, "a"},
                    {"bx", place, "b"},
                    {"by", place, "b"},
                    {"bz", place, "b"},
                    {"cx", place, "c"},
                    {"cy", place, "c"},
                    {"cz", place, "c"},
                    {"px", place, "p"},
                    {"py", place, "p"},
                    {"pz", place, "p"},
                    {"dx", direction, "d"},
                    {"dy", direction, "d"},
                    {"dz", direction, "d"},
                    {"r", Role::length, "r"}}}},
      .comparisons = {},
      .clauses = {},
      .measures = {},
  };
  for (std::size_t i = 0; i < moving_sphere::comparison_names.size(); ++i) {
    const std::string_view clause = moving_sphere::clause_name(i);
    if (test.clauses.empty() || test.clauses.back().name != clause) test.clauses.push_back({clause, 0});
    test.clauses.back().comparisons |= one_bit<ComparisonBits>(i);
    test.comparisons.push_back(
        {moving_sphere::comparison_names[i], test.clauses.size() - 1, moving_sphere::is_radius(i)});
  }
  return checked(std::move(test));
}

}  // namespace

const TestDescription& moving_sphere_test() {
  static const TestDescription test = moving_sphere_described();
  return test;
}

}  // namespace axiscert
