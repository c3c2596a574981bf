#include "fuzz/confirm/slack.h"

#include <gtest/gtest.h>

#include <set>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/brackets.h"
#include "fuzz/confirm/planted_slacks_testing.h"
#include "fuzz/files/query_file.h"

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
  const std::string unit = "the queries' unit";
  return {
      {"skin", [] { return sphere("skin", {.skin = 1e-4}); }, both, relative, "r", 1e-4},
      {"thick_skin", [] { return sphere("thick", {.skin = 0.1}); }, both, relative, "r", 0.1, "any feature"},
      {"thin_skin", [] { return sphere("thin", {.skin = -1e-6}); }, {twice}, relative, "r", 1e-6},
      {"skin_of_face", [] { return sphere("face", {.skin_of_face = 1e-4}); }, both, relative, "r", 1e-4, "the face"},
      {"margin", [] { return sphere("margin", {.margin = 1e-3}); }, both, absolute, unit, 1e-3},
      {"small_margin", [] { return sphere("margin", {.margin = 1e-6}); }, {twice}, absolute, unit, 1e-6},
      {"barycentric",
       [] { return sphere("weights", {.barycentric = 1e-3}); },
       {twice},
       relative,
       "the triangle's height",
       1e-3,
       "edge"},
      {"long_edge", [] { return sphere("edge", {.edge = 1e-3}); }, {twice}, relative, "the edge", 1e-3, "along"},
      {"moving_skin", [] { return moving("skin", 1e-4, 0, 0); }, both, relative, "r", 1e-4},
      {"moving_margin", [] { return moving("margin", 0, 1e-3, 0); }, both, absolute, unit, 1e-3},
      {"late_time", [] { return moving("time", 0, 0, 1e-4); }, {twice}, relative, "the motion", 1e-4},
      {"box_margin", [] { return boxes_by_book("margin", {.margin = 1e-3}); }, both, absolute, unit, 1e-3},
      {"small_box_margin", [] { return boxes_by_book("margin", {.margin = 1e-6}); }, {twice}, absolute, unit, 1e-6},
      {"epsilon_of_edges", [] { return boxes_by_book("edges", {.edges = 1e-3}); }, both, relative, "half extents", 1e-3,
       "edges"},
      {"small_epsilon_of_edges",
       [] { return boxes_by_book("edges", {.edges = 1e-6}); },
       {twice},
       relative,
       "half extents",
       1e-6,
       "edges"},
      {"epsilon_of_all", [] { return boxes_by_book("all", {.all = 1e-3}); }, both, relative, "half extents", 1e-3},
      {"relative", [] { return boxes_by_book("relative", {.relative = 1e-4}); }, both, relative, "half extents", 1e-4},
      {"inflated", [] { return boxes_by_book("inflated", {.inflated = 1e-3}); }, both, relative, "half extents", 1e-3},
      {"least_half_beside_a_triangle",
       [] {
         return planted::changed("least", find_kernel("box-triangle/akenine-moller"), [](auto& q) {
           using Real = std::remove_reference_t<decltype(q[0])>;
           for (std::size_t k = 3; k < 6; ++k) q[k] = std::max(q[k], Real(1e-3));
         });
       },
       both, absolute, unit, 1e-3, "flat"},
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
      return slack.kind == planted.kind && slack.to.find(planted.to) != std::string::npos &&
             slack.size >= planted.size / 2 && slack.size <= planted.size * 2 &&
             slack.where.find(planted.where) != std::string::npos;
    };
    const auto found = std::ranges::find_if(slacks->found, is_it);
    ASSERT_NE(found, slacks->found.end());
    const StoredQuery query = parse_queries(found->witness + "\n", "witness", precision).front();
    const Truth truth =
        std::visit([&](const auto& numbers) { return oracles_of(kernel).truth(numbers); }, query.numbers);
    EXPECT_NE(truth.verdict, found->said);
  }
}
INSTANTIATE_TEST_SUITE_P(Made, PlantedSlacks, testing::ValuesIn(planted_kernels()),
                         [](const auto& row) { return row.param.name; });

// What is taken for rounding is more than the built-in forms that are right over the reals need.
template <class Real>
double worst_of(const Kernel& kernel) {
  double worst = 0;
  for (const Bracket& one : brackets_of<Real>(kernel, 2, std::string(scalar_target)).all)
    worst = std::max(worst, std::abs(one.early) / one.rounding);
  return worst;
}
TEST(Slacks, RightFormsRoundLessThanIsTakenForRounding) {
  for (const char* id :
       {"published", "nonstrict", "reduced", "closest-point", "minkowski", "segments", "moving-sphere/twenty-nonstrict",
        "box-box/textbook", "box-box/columns", "box-triangle/akenine-moller"}) {
    EXPECT_LT(worst_of<float>(find_kernel(id)), 0.7) << id;
    EXPECT_LT(worst_of<double>(find_kernel(id)), 0.7) << id;
  }
}

// The kernels that come with axiscert have none, but for those that have a tolerance or an epsilon of their own, and
// the formulae of the first publication, which are wrong. A slack of a ten-thousandth would be seen.
TEST(Slacks, RightKernelsHaveNone) {
  const std::set<std::string> others = {"first-publication", "moving-sphere/advance-by-length", "moving-sphere/fauerby",
                                        "moving-sphere/physx4"};
  std::size_t asked = 0;
  for (const Kernel& kernel : kernels()) {
    const bool is_of_a_book = kernel.id.find("slip") != kernel.id.npos || kernel.id.find("rtcd") != kernel.id.npos ||
                              kernel.id.find("bullet") != kernel.id.npos ||
                              kernel.id.find("gottschalk") != kernel.id.npos;
    for (const Precision precision : {single, twice}) {
      if (is_of_a_book || others.contains(kernel.id) || !kernel.has(precision)) continue;
      if (asked++ % 3 != 0) continue;  // the others are forms and arithmetics of these
      const auto slacks = slacks_of(kernel, precision, 1, std::string(scalar_target));
      if (!slacks) continue;
      SCOPED_TRACE(kernel.id + " " + std::string(name(precision)) + " " + no_slack_text(*slacks));
      for (const SlackRecord& slack : slacks->found) ADD_FAILURE() << slack_text(slack) << "\n" << slack.witness;
      if (slacks->bracketed >= 200) {
        EXPECT_LE(least_relative(*slacks), precision == single ? 1.1e-4 : 1e-10);
      }
    }
  }
}

TEST(Slacks, TheEpsilonsOfBooksAreNamed) {
  const auto slacks = slacks_of(find_kernel("box-box/gottschalk"), twice, 1, std::string(scalar_target));
  ASSERT_TRUE(slacks && !slacks->found.empty());
  EXPECT_EQ(slacks->found.front().side, SlackSide::early);
  EXPECT_NEAR(slacks->found.front().size, 1e-6, 1e-6);
}

// Too far off for a slack, which another answer would explain as well: not by one size, and not in silence.
TEST(Slacks, AnswersThatAreFarOffAreToldBySize) {
  const auto slacks = slacks_of(planted::sphere("half", {.skin = 0.5}), twice, 1, std::string(scalar_target));
  ASSERT_TRUE(slacks);
  const SlackLook* const off = most_off(*slacks, SlackKind::relative);
  ASSERT_NE(off, nullptr);
  EXPECT_GT(off->off_relative, 0.1);
  EXPECT_LE(off->off_relative, 0.5001);
  const auto right = slacks_of(find_kernel("published"), twice, 1, std::string(scalar_target));
  EXPECT_EQ(most_off(*right, SlackKind::relative), nullptr);
  EXPECT_EQ(most_off(*right, SlackKind::absolute), nullptr);
  EXPECT_TRUE(right->blind.empty()) << blind_text(*right);
}

// A margin that a kernel declares hides what is smaller.
TEST(Slacks, NothingBelowADeclaredMarginWouldBeSeen) {
  Kernel kernel = planted::sphere("margin", {.skin = 0.01});
  kernel.limits.margin = 0.05;
  const auto slacks = slacks_of(kernel, twice, 1, std::string(scalar_target));
  ASSERT_TRUE(slacks);
  ASSERT_TRUE(least_absolute(*slacks));
  EXPECT_GE(*least_absolute(*slacks), 0.05);
}

TEST(Slacks, AKindOnWhichTheAnswerNeverTurnsIsNamed) {
  const auto slacks =
      slacks_of(planted::sphere("no vertices", {.has_vertices = false}), twice, 1, std::string(scalar_target));
  ASSERT_TRUE(slacks);
  EXPECT_GT(slacks->bracketed, 300u);
  ASSERT_FALSE(slacks->blind.empty());
  EXPECT_NE(blind_text(*slacks).find("vert"), std::string::npos) << blind_text(*slacks);
}

// Without a kernel that answers there is nothing to say, and no slack either.
TEST(Slacks, AKernelThatNeverTurnsIsNotBracketed) {
  const Kernel never =
      planted::kernel_of("never", sphere_triangle_predicate(), [](const auto&) { return Verdict::separated; });
  const auto slacks = slacks_of(never, twice, 1, std::string(scalar_target));
  ASSERT_TRUE(slacks);
  EXPECT_EQ(slacks->bracketed, 0u);
  EXPECT_TRUE(slacks->found.empty());
  EXPECT_FALSE(least_relative(*slacks));
  EXPECT_FALSE(slacks->blind.empty());
}

}  // namespace
}  // namespace axiscert
