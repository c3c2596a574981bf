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
      .measures = {},
      .greatest_depth = 1.58,
  };
  for (std::size_t i = 0; i < boxes::axis_count; ++i) {
    predicate.clauses.push_back({boxes::axis_names[i], one_bit<ComparisonBits>(i)});
    predicate.comparisons.push_back({boxes::axis_names[i], i});
  }
  return checked(std::move(predicate));
}

}  // namespace

const Predicate& box_box_predicate() {
  static const Predicate predicate = box_box_described();
  return predicate;
}

}  // namespace axiscert
