// The attribution of flips, on families where the cause is known, and for a planted fault.
#include "fuzz/sphere_triangle/formulae/condition.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "fuzz/queries/family.h"
#include "fuzz/instruments/instruments_testing.h"

namespace axiscert {
namespace {

ConditionPlan condition_plan(std::vector<const Kernel*> kernels, std::vector<std::string_view> families) {
  ConditionPlan plan;
  plan.kernels = std::move(kernels);
  for (const auto name : families) plan.sources.push_back(family_source(find_family(name)));
  plan.trials = 700;
  plan.flip_limit = 40;
  plan.sample = 10;
  return plan;
}

void expect_consistent(const ConditionCounts& c, const ConditionPlan& plan) {
  EXPECT_EQ(c.evaluated, std::min(c.flips, plan.flip_limit));
  EXPECT_EQ(c.evaluated, c.ill_conditioned + c.unstable + c.undefined + c.not_decided);
  EXPECT_LE(c.ties, c.ill_conditioned);
  EXPECT_LE(c.range, c.unstable);
  EXPECT_EQ(c.least_unstable.has_value(), c.unstable > c.range);
  EXPECT_LE(c.sampled, plan.sample);
}

TEST(ConditionInstrument, TangencyToAnUlpIsTheQuerysFaultAndOverflowTheFormulas) {
  const auto plan =
      condition_plan({&find_kernel("published"), &find_kernel("ladder-0")}, {"general", "tangent", "scale"});
  const ConditionResult result = measure_condition(plan);
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    for (const ConditionCell& cell : result.cells[k]) {
      for (const ConditionCounts& counts : cell.comparisons) expect_consistent(counts, plan);
      EXPECT_EQ(cell.depths.size(), cell.false_separation + cell.false_contact);
    }
    const ConditionCounts general = result.cells[k][0].total(), tangent = result.cells[k][1].total(),
                          scale = result.cells[k][2].total();
    EXPECT_EQ(general.flips, 0u);
    EXPECT_GT(general.sampled, 0u);
    EXPECT_LT(general.greatest_right->value.value(), 1);
    EXPECT_GT(tangent.flips, 0u);
    EXPECT_EQ(tangent.ill_conditioned, tangent.evaluated);
    EXPECT_GT(scale.range, 0u);
    EXPECT_EQ(scale.range, scale.unstable) << "at other scales the same queries are right";
  }
}

TEST(ConditionInstrument, AWrongBitOnWellConditionedQueriesIsUnstable) {
  const Kernel planted = published_with_a_wrong_bit(Comparison::edge_bc_side_a);
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    auto plan = condition_plan({&planted}, {"general"});
    plan.precision = precision;
    const ConditionCell cell = measure_condition(plan).cells[0][0];
    const ConditionCounts& wrong = cell.comparisons[Comparison::edge_bc_side_a];
    EXPECT_EQ(wrong.flips, plan.trials);
    EXPECT_EQ(wrong.evaluated, plan.flip_limit);
    EXPECT_EQ(wrong.unstable, plan.flip_limit);
    EXPECT_EQ(wrong.range, 0u) << "the formula itself is right there";
    EXPECT_LT(wrong.least_unstable->position, plan.flip_limit) << "the first flips are evaluated";
    EXPECT_EQ(cell.total().flips, wrong.flips);
  }
}

TEST(ConditionInstrument, DoesNotDependOnThreads) {
  const auto plan =
      condition_plan({&find_kernel("published"), &find_kernel("ladder-0")}, {"seam", "sliver", "collinear"});
  std::vector<ConditionResult> results;
  for (const std::size_t threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(measure_condition(plan));
  }
  EXPECT_TRUE(results[0] == results[1]);
  EXPECT_GT(results[0].cells[0][1].total().flips, 0u);
}

}  // namespace
}  // namespace axiscert
