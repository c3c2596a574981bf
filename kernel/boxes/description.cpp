#include "kernel/boxes/boxes.h"
#include "kernel/boxes/names.h"

namespace axiscert {
namespace {

void add_group(std::vector<PredicateColumn>& columns, Role role, std::string_view group,
               std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) columns.push_back({name, role, group});
}

std::vector<PredicateColumn> matrix_columns() {
  constexpr Role place = Role::coordinate, direction = Role::direction, length = Role::length;
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "a.m", {"a.mx", "a.my", "a.mz"});
  add_group(columns, length, "a.s", {"a.s0", "a.s1", "a.s2"});
  add_group(columns, direction, "a.b.0", {"a.b0x", "a.b0y", "a.b0z"});
  add_group(columns, direction, "a.b.1", {"a.b1x", "a.b1y", "a.b1z"});
  add_group(columns, direction, "a.b.2", {"a.b2x", "a.b2y", "a.b2z"});
  add_group(columns, place, "b.m", {"b.mx", "b.my", "b.mz"});
  add_group(columns, length, "b.s", {"b.s0", "b.s1", "b.s2"});
  add_group(columns, direction, "b.b.0", {"b.b0x", "b.b0y", "b.b0z"});
  add_group(columns, direction, "b.b.1", {"b.b1x", "b.b1y", "b.b1z"});
  add_group(columns, direction, "b.b.2", {"b.b2x", "b.b2y", "b.b2z"});
  return columns;
}

std::vector<PredicateColumn> quaternion_columns() {
  constexpr Role place = Role::coordinate, direction = Role::direction, length = Role::length;
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "a.m", {"a.mx", "a.my", "a.mz"});
  add_group(columns, length, "a.s", {"a.s0", "a.s1", "a.s2"});
  add_group(columns, direction, "a.q", {"a.qw", "a.qx", "a.qy", "a.qz"});
  add_group(columns, place, "b.m", {"b.mx", "b.my", "b.mz"});
  add_group(columns, length, "b.s", {"b.s0", "b.s1", "b.s2"});
  add_group(columns, direction, "b.q", {"b.qw", "b.qx", "b.qy", "b.qz"});
  return columns;
}

std::vector<PredicateColumn> minmax_columns() {
  constexpr Role place = Role::coordinate;
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "a.min", {"a.minx", "a.miny", "a.minz"});
  add_group(columns, place, "a.max", {"a.maxx", "a.maxy", "a.maxz"});
  add_group(columns, place, "b.min", {"b.minx", "b.miny", "b.minz"});
  add_group(columns, place, "b.max", {"b.maxx", "b.maxy", "b.maxz"});
  return columns;
}

// A's of the former, B's of quaternions.
std::vector<PredicateColumn> mixed_columns() {
  std::vector<PredicateColumn> columns = minmax_columns();
  const std::vector<PredicateColumn> turned = quaternion_columns();
  columns.erase(columns.begin() + 6, columns.end());
  columns.insert(columns.end(), turned.begin() + 10, turned.end());
  return columns;
}

Predicate box_box_described() {
  Predicate predicate{
      .id = "box-box",
      .asks = "do two closed oriented boxes have a point in common",
      .touching = "they have a point in common, and a translation of one of them, as small as you like, parts them",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"matrix", "every number finite, half extents 0 or more, the determinant of each basis not 0",
                   matrix_columns()},
                  {"quaternion", "every number finite, half extents 0 or more, every quaternion other than 0",
                   quaternion_columns()},
                  {"minmax", "every number finite, no coordinate of a corner min above that of max", minmax_columns()},
                  {"minmax-quaternion",
                   "every number finite, no coordinate of A's min above that of max, half extents 0 or more, the "
                   "quaternion other than 0",
                   mixed_columns()}},
      .comparisons = {},
      .clauses = {},
      .measures = boxes::measures_of_contacts("of A's point", "of B's point"),
      .greatest_depth = 1.58,
  };
  for (std::size_t i = 0; i < boxes::axis_count; ++i) {
    predicate.clauses.push_back({boxes::axis_names[i], one_bit<ComparisonBits>(i)});
    predicate.comparisons.push_back({boxes::axis_names[i], i});
  }
  return checked(std::move(predicate));
}

}  // namespace

std::vector<PredicateMeasure> boxes::measures_of_contacts(std::string_view point_a, std::string_view point_b) {
  constexpr std::string_view normal = "of the unit vector in which the second body is pushed",
                             angle =
                                 "of the three, the angle in radians where one axis is least; and what a push by the "
                                 "exact depth leaves of it",
                             distance =
                                 "of the three, the distance from its body, relative to the scene, as a depth; and "
                                 "how far both are from as far apart as the separation is";
  return {{"separation",
           "distance of bodies apart, less the penetration of others, in the unit of the coordinates; NaN: "
           "none is given",
           "relative to the scene, in ulps of the number nearest to the exact one, and in u of the scene",
           MeasureKind::separation},
          {"normal_x", normal, angle, MeasureKind::normal},
          {"normal_y", normal, angle, MeasureKind::normal},
          {"normal_z", normal, angle, MeasureKind::normal},
          {"point_a_x", point_a, distance, MeasureKind::point_a},
          {"point_a_y", point_a, distance, MeasureKind::point_a},
          {"point_a_z", point_a, distance, MeasureKind::point_a},
          {"point_b_x", point_b, distance, MeasureKind::point_b},
          {"point_b_y", point_b, distance, MeasureKind::point_b},
          {"point_b_z", point_b, distance, MeasureKind::point_b}};
}

const Predicate& box_box_predicate() {
  static const Predicate predicate = box_box_described();
  return predicate;
}

}  // namespace axiscert
