#include "fuzz/testing/point_box/point_box.h"

#include "fuzz/queries/capabilities.h"

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

namespace {

// Planted: the last face is compared with the height of another.
struct WrongFace {
  static constexpr std::string_view name = PointBoxFaces::name;
  template <class T, class Sink>
  static void comparisons(const PointBox::Problem<T>& q, Sink& sink) {
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) { sink(i, lhs, i == 5 ? q.high.y : rhs); };
    PointBoxFaces::comparisons<T>(q, planted);
  }
};

}  // namespace

std::vector<Kernel> point_box_kernels() {
  return {
      formulae_kernel<PointBox, PointBoxFaces>("point-box/strict", "beyond a face, by six comparisons"),
      formulae_kernel<PointBox, WrongFace>("point-box/fault", "the same with z.above against hy: wrong"),
  };
}

const Capabilities& point_box_capabilities() {
  static const Capabilities all = {.section_of_forms = "docs/kernels.md"};
  return all;
}

}  // namespace axiscert
