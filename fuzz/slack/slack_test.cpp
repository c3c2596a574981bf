#include "fuzz/slack/slack.h"

#include <gtest/gtest.h>

#include "exact/trait/oracles.h"
#include "fuzz/files/query_file.h"
#include "fuzz/slack/planted_slacks_testing.h"

namespace axiscert {
namespace {

constexpr Precision single = Precision::binary32, twice = Precision::binary64;

struct Planted {
  std::string name;
  std::function<Kernel()> make;
  std::vector<Precision> precisions;
  SlackKind kind;
  std::string to;
  double size;
  std::string where = {};  // in the text of the first; empty: anywhere
};

Kernel moving(const std::string& name, double skin, double margin, double time) {
  return planted::changed(name, find_kernel("moving-sphere/twenty-nonstrict"), [=](auto& q) {
    using Real = std::remove_reference_t<decltype(q[0])>;
    q[15] = q[15] + q[15] * static_cast<Real>(skin) + static_cast<Real>(margin);
    for (std::size_t k = 12; k < 15; ++k) q[k] = q[k] + q[k] * static_cast<Real>(time);
  });
}

std::vector<Planted> planted_kernels() {
  using planted::boxes_by_book, planted::sphere;
  const std::vector<Precision> both = {single, twice};
  constexpr SlackKind absolute = SlackKind::absolute, relative = SlackKind::relative;
  const std::string unit = "the queries' unit", sum = "the sum of a box's half extents";
  return {
      {"skin", [] { return sphere("skin", {.skin = 1e-4}); }, both, relative, "r", 1e-4},
      {"thin_skin", [] { return sphere("thin", {.skin = -1e-6}); }, {twice}, relative, "r", 1e-6},
      {"skin_of_face", [] { return sphere("face", {.skin_of_face = 1e-4}); }, both, relative, "r", 1e-4, "the face"},
      {"margin", [] { return sphere("margin", {.margin = 1e-3}); }, both, absolute, unit, 1e-3},
      {"small_margin", [] { return sphere("margin", {.margin = 1e-6}); }, {twice}, absolute, unit, 1e-6},
      {"barycentric", [] { return sphere("weights", {.barycentric = 1e-3}); }, {twice}, relative,
       "the triangle's height", 1e-3, "edge"},
      {"long_edge", [] { return sphere("edge", {.edge = 1e-3}); }, {twice}, relative, "the edge", 1e-3, "edge"},
      {"moving_skin", [] { return moving("skin", 1e-4, 0, 0); }, both, relative, "r", 1e-4},
      {"moving_margin", [] { return moving("margin", 0, 1e-3, 0); }, both, absolute, unit, 1e-3},
      {"late_time", [] { return moving("time", 0, 0, 1e-4); }, both, relative, "the motion", 1e-4},
      {"box_margin", [] { return boxes_by_book("margin", {.margin = 1e-3}); }, both, absolute, unit, 1e-3},
      {"small_box_margin", [] { return boxes_by_book("margin", {.margin = 1e-6}); }, {twice}, absolute, unit, 1e-6},
      {"epsilon_of_edges", [] { return boxes_by_book("edges", {.edges = 1e-3}); }, both, relative, sum, 1e-3, "edges"},
      {"small_epsilon_of_edges", [] { return boxes_by_book("edges", {.edges = 1e-6}); }, {twice}, relative, sum, 1e-6,
       "edges"},
      {"epsilon_of_all", [] { return boxes_by_book("all", {.all = 1e-3}); }, both, relative, sum, 1e-3},
      {"relative", [] { return boxes_by_book("relative", {.relative = 1e-4}); }, both, relative, sum, 1e-4},
      {"inflated", [] { return boxes_by_book("inflated", {.inflated = 1e-3}); }, both, relative,
       "the half extents along the axis", 1e-3},
      {"least_half", [] { return boxes_by_book("least", {.least_half = 1e-3}); }, both, absolute, unit, 1e-3, "flat"},
  };
}

class PlantedSlacks : public testing::TestWithParam<Planted> {};

TEST_P(PlantedSlacks, IsFoundWithItsKindAndSize) {
  const Planted& planted = GetParam();
  const Kernel kernel = planted.make();
  for (const Precision precision : planted.precisions) {
    const auto slacks = slacks_of(kernel, precision, 1, std::string(scalar_target));
    ASSERT_TRUE(slacks);
    std::string all;
    for (const SlackRecord& slack : slacks->found) all += "\n" + slack_text(slack);
    SCOPED_TRACE(std::string(name(precision)) + all);
    ASSERT_FALSE(slacks->found.empty());
    const auto is_it = [&](const SlackRecord& slack) {
      return slack.kind == planted.kind && slack.to == planted.to && slack.size >= planted.size / 2 &&
             slack.size <= planted.size * 2 && slack.where.find(planted.where) != std::string::npos;
    };
    const auto found = std::ranges::find_if(slacks->found, is_it);
    ASSERT_NE(found, slacks->found.end());
    const StoredQuery query = parse_queries(found->witness + "\n", "witness", precision).front();
    const Truth truth = std::visit([&](const auto& numbers) { return oracles_of(kernel).truth(numbers); }, query.numbers);
    EXPECT_NE(truth.verdict, found->said);
  }
}
INSTANTIATE_TEST_SUITE_P(Made, PlantedSlacks, testing::ValuesIn(planted_kernels()),
                         [](const auto& row) { return row.param.name; });

// Right forms have none, at several seeds; and a slack of a ten-thousandth would be seen.
TEST(Slacks, RightKernelsHaveNone) {
  for (const Kernel& kernel : kernels()) {
    const bool is_right = kernel.summary.find("slip") == std::string::npos;
    for (const Precision precision : {single, twice}) {
      if (!is_right || !kernel.has(precision)) continue;
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const auto slacks = slacks_of(kernel, precision, seed, std::string(scalar_target));
        if (!slacks) continue;
        SCOPED_TRACE(kernel.id + " " + std::string(name(precision)) + " " + no_slack_text(*slacks));
        for (const SlackRecord& slack : slacks->found) ADD_FAILURE() << slack_text(slack) << "\n" << slack.witness;
        if (least_bracketed <= slacks->bracketed) {
          EXPECT_LE(least_relative(*slacks), precision == single ? 1e-4 : 1e-10);
        }
      }
    }
  }
}

}  // namespace
}  // namespace axiscert
