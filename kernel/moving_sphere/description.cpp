#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert {

void moving_sphere::add_twenty_axes(Predicate& predicate) {
  for (std::size_t i = 0; i < comparison_names.size(); ++i) {
    const std::string_view clause = clause_name(i);
    if (predicate.clauses.empty() || predicate.clauses.back().name != clause) predicate.clauses.push_back({clause, 0});
    predicate.clauses.back().comparisons |= one_bit<ComparisonBits>(i);
    predicate.comparisons.push_back({comparison_names[i], predicate.clauses.size() - 1, is_radius(i)});
  }
}

namespace {

constexpr Role place = Role::coordinate, direction = Role::direction;

// The three columns that say where the motion goes.
struct MotionColumns {
  std::string_view group;
  Role role;
  std::string_view x, y, z;
};
std::vector<PredicateColumn> columns(const MotionColumns& to) {
  return {{"ax", place, "a"},        {"ay", place, "a"},        {"az", place, "a"},        {"bx", place, "b"},
          {"by", place, "b"},        {"bz", place, "b"},        {"cx", place, "c"},        {"cy", place, "c"},
          {"cz", place, "c"},        {"px", place, "p"},        {"py", place, "p"},        {"pz", place, "p"},
          {to.x, to.role, to.group}, {to.y, to.role, to.group}, {to.z, to.role, to.group}, {"r", Role::length, "r"}};
}

Predicate moving_sphere_described() {
  constexpr std::string_view validity = "every number finite, the radius not negative; -0 is 0";
  constexpr std::string_view normal = "of the unit vector from the triangle's nearest point to the centre at contact",
                             angle = "of the three, the angle in radians where the two are apart at the first contact",
                             point = "of the triangle's point at contact, in the unit of the coordinates",
                             distance = "of the three, the distance relative to the scene, as a depth";
  Predicate predicate{
      .id = "moving-sphere",
      .asks = "does a closed solid sphere that moves along a line have a point in common with a closed triangle",
      .touching =
          "the least distance from the moving centre to the triangle is exactly the radius, unless a point (r = 0) "
          "crosses the inside of the face",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"displacement", validity, columns({"d", direction, "dx", "dy", "dz"})},
                  {"endpoints", validity, columns({"p1", place, "p1x", "p1y", "p1z"})}},
      .comparisons = {},
      .clauses = {},
      .measures = {{"time", "fraction of the displacement at the first contact, from 0 to 1; NaN: none is given",
                    "late or early; in ulps of the greatest number that is not late, and in u of the displacement",
                    MeasureKind::time},
                   {"feature", "0, 1, 2: vertex a, b, c; 3, 4, 5: edge ab, bc, ca; 6: face; NaN: none is given",
                    "wrong where another part of the triangle is nearer to the centre at the first contact",
                    MeasureKind::feature},
                   {"normal_x", normal, angle, MeasureKind::normal},
                   {"normal_y", normal, angle, MeasureKind::normal},
                   {"normal_z", normal, angle, MeasureKind::normal},
                   {"point_x", point, distance, MeasureKind::point},
                   {"point_y", point, distance, MeasureKind::point},
                   {"point_z", point, distance, MeasureKind::point}},
  };
  predicate.entries[1].has_free_numbers = false;  // both ends say where the sphere is
  moving_sphere::add_twenty_axes(predicate);
  return checked(std::move(predicate));
}

}  // namespace

const Predicate& moving_sphere_predicate() {
  static const Predicate predicate = moving_sphere_described();
  return predicate;
}

}  // namespace axiscert
