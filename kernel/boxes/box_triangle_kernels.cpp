// The description and the kernels of a box and a triangle.
#include "kernel/boxes/akenine_moller.h"
#include "kernel/boxes/contact.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert {

std::vector<Kernel> box_triangle_kernels();

namespace {

constexpr Role place = Role::coordinate, direction_role = Role::direction, length = Role::length;

void add_group(std::vector<PredicateColumn>& columns, Role role, std::string_view group,
               std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) columns.push_back({name, role, group});
}
void add_triangle(std::vector<PredicateColumn>& columns) {
  add_group(columns, place, "a", {"ax", "ay", "az"});
  add_group(columns, place, "b", {"bx", "by", "bz"});
  add_group(columns, place, "c", {"cx", "cy", "cz"});
}

std::vector<PredicateColumn> centre_columns() {
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "box.m", {"box.mx", "box.my", "box.mz"});
  add_group(columns, length, "box.s", {"box.s0", "box.s1", "box.s2"});
  add_triangle(columns);
  return columns;
}
std::vector<PredicateColumn> minmax_columns() {
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "box.min", {"box.minx", "box.miny", "box.minz"});
  add_group(columns, place, "box.max", {"box.maxx", "box.maxy", "box.maxz"});
  add_triangle(columns);
  return columns;
}
std::vector<PredicateColumn> oriented_columns() {
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "box.m", {"box.mx", "box.my", "box.mz"});
  add_group(columns, length, "box.s", {"box.s0", "box.s1", "box.s2"});
  add_group(columns, direction_role, "box.b.0", {"box.b0x", "box.b0y", "box.b0z"});
  add_group(columns, direction_role, "box.b.1", {"box.b1x", "box.b1y", "box.b1z"});
  add_group(columns, direction_role, "box.b.2", {"box.b2x", "box.b2y", "box.b2z"});
  add_triangle(columns);
  return columns;
}

std::vector<PredicateColumn> turned_columns() {
  std::vector<PredicateColumn> columns;
  add_group(columns, place, "box.m", {"box.mx", "box.my", "box.mz"});
  add_group(columns, length, "box.s", {"box.s0", "box.s1", "box.s2"});
  add_group(columns, direction_role, "box.q", {"box.qw", "box.qx", "box.qy", "box.qz"});
  add_triangle(columns);
  return columns;
}

Predicate box_triangle_described() {
  Predicate predicate{
      .id = "box-triangle",
      .asks = "do a closed box and a closed triangle have a point in common",
      .touching = "they have a point in common, and a translation of one of them, as small as you like, parts them",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"centre", "every number finite, half extents 0 or more", centre_columns()},
                  {"minmax", "every number finite, no coordinate of the corner min above that of max",
                   minmax_columns()},
                  {"matrix", "every number finite, half extents 0 or more, the determinant of the basis not 0",
                   oriented_columns()},
                  {"quaternion", "every number finite, half extents 0 or more, the quaternion other than 0",
                   turned_columns()}},
      .comparisons = {},
      .clauses = {},
      .measures = boxes::measures_of_contacts("of the box's point", "of the triangle's point"),
      .has_front = true,
  };
  for (std::size_t i = 0; i < boxes::thirteen_count; ++i) {
    predicate.clauses.push_back({boxes::thirteen_names[i], one_bit<ComparisonBits>(i)});
    predicate.comparisons.push_back({boxes::thirteen_names[i], i});
  }
  return checked(std::move(predicate));
}

using namespace boxes;

}  // namespace

const Predicate& box_triangle_predicate() {
  static const Predicate predicate = box_triangle_described();
  return predicate;
}

std::vector<Kernel> box_triangle_kernels() {
  return {
      formulae_kernel<CentreEntry, WithTriangleContact<TextbookThirteen>>(
          "box-triangle/textbook",
          "thirteen axes, terms that are 0 left out, as in books; numbers by the least of them"),
      formulae_kernel<CentreEntry, AkenineMoller>(
          "box-triangle/akenine-moller", "the same axes as the paper's program has them (Akenine-Moller, 2001)"),
      formulae_kernel<CentreEntry, Thirteen>("box-triangle/thirteen", "the same, products of the edges, all terms"),
      formulae_kernel<MinmaxEntry, WithTriangleContact<TextbookThirteen>>(
          "box-triangle/textbook-minmax", "textbook, centre and half extents computed of two corners"),
      formulae_kernel<MinmaxEntry, AkenineMoller>("box-triangle/akenine-moller-minmax",
                                                  "akenine-moller, centre and half extents computed of two corners"),
      formulae_kernel<MinmaxEntry, Thirteen>("box-triangle/thirteen-minmax", "thirteen, of two corners"),
      formulae_kernel<OrientedEntry, WithTriangleContact<FramedThirteen>>(
          "box-triangle/textbook-oriented", "the triangle in the frame of an oriented box, then textbook"),
      formulae_kernel<OrientedEntry, Thirteen>("box-triangle/thirteen-oriented",
                                               "thirteen, products of the box's own vectors: right over the reals"),
      formulae_kernel<TurnedEntry, WithTriangleContact<TurnedThirteen>>(
          "box-triangle/textbook-turned", "textbook-oriented, the quaternion turned into a matrix"),
      formulae_kernel<TurnedEntry, Thirteen>("box-triangle/thirteen-turned",
                                             "thirteen-oriented, the quaternion turned into a matrix"),
  };
}

}  // namespace axiscert
