#include "fuzz/testing/point_box/point_box.h"

namespace axiscert {
namespace {

Predicate point_box_described() {
  constexpr Role place = Role::coordinate;
  Predicate predicate{
      .id = "point-box",
      .asks = "does a point lie in a closed box along the axes",
      .touching = "the point is on the box's surface",
      .wrong_answers = {{Verdict::separated, Verdict::contact, "missed contact"},
                        {Verdict::contact, Verdict::separated, "phantom contact"}},
      .entries = {{"corners",
                   "every number finite, no corner `l` above its `h`",
                   {{"px", place, "p"},
                    {"py", place, "p"},
                    {"pz", place, "p"},
                    {"lx", place, "l"},
                    {"ly", place, "l"},
                    {"lz", place, "l"},
                    {"hx", place, "h"},
                    {"hy", place, "h"},
                    {"hz", place, "h"}}}},
      .comparisons = {{"x.below", 0}, {"x.above", 1}, {"y.below", 2}, {"y.above", 3}, {"z.below", 4}, {"z.above", 5}},
      .clauses = {{"x_below", 1}, {"x_above", 2}, {"y_below", 4}, {"y_above", 8}, {"z_below", 16}, {"z_above", 32}},
      .measures = {},
  };
  return checked(std::move(predicate));
}

}  // namespace

const Predicate& point_box_predicate() {
  static const Predicate predicate = point_box_described();
  return predicate;
}

}  // namespace axiscert
