#include "kernel/boxes/boxes.h"
#include "kernel/capsule_triangle/capsule.h"

namespace axiscert {
namespace {

constexpr Role place = Role::coordinate;

Predicate capsule_triangle_described() {
  Predicate predicate{
      .id = "capsule-triangle",
      .asks = "does a closed solid capsule have a point in common with a closed triangle",
      .touching =
          "the distance from the capsule's segment to the triangle is exactly the radius, unless the segment (r = 0) "
          "crosses the inside of the face",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"endpoints",
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
                    {"qx", place, "q"},
                    {"qy", place, "q"},
                    {"qz", place, "q"},
                    {"r", Role::length, "r"}}}},
      .comparisons = {},
      .clauses = {},
      .measures = boxes::measures_of_contacts("of the capsule's point", "of the triangle's point"),
      .greatest_depth = 2,
  };
  moving_sphere::add_twenty_axes(predicate);
  return checked(std::move(predicate));
}

}  // namespace

const Predicate& capsule_triangle_predicate() {
  static const Predicate predicate = capsule_triangle_described();
  return predicate;
}

}  // namespace axiscert
