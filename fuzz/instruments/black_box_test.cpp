// A mutant that shows its verdict alone is refused as the gate says, or passes for a reason.
#include "fuzz/instruments/black_box.h"

#include <gtest/gtest.h>

#include <tuple>

namespace axiscert {
namespace {

constexpr std::uint64_t box_seed = 7;
const std::atomic<bool> never_stopped = false;

MutationPlan box_plan(const std::vector<const char*>& mutants, std::uint64_t trials) {
  MutationPlan plan;
  for (const char* id : mutants) plan.mutants.push_back(&mutants::find_mutant(id));
  plan.base = "nonstrict";
  plan.families = {&find_family("lattice"), &find_family("tangent")};
  plan.precisions = {Precision::binary32};
  plan.trials = trials;
  plan.seed = box_seed;
  plan.threads = 2;
  return plan;
}

// A gate of the test's own: wrong verdicts in exact arithmetic, spheres that touch apart.
std::vector<GateFailure> wrong_in_exact_arithmetic(const Record& record) {
  std::vector<GateFailure> failures;
  for (const KernelRecord& kernel : record.kernels) {
    EXPECT_FALSE(kernel.reference);  // nothing but verdicts is known of it
    for (const auto& [family, result] : kernel.families) {
      const VerdictTally& verdict = result.verdict;
      if (result.exact_arithmetic && verdict.false_separation + verdict.false_contact > verdict.touching_flips)
        failures.push_back({kernel.id, std::string(name(kernel.precision)), family, "wrong"});
    }
  }
  return failures;
}

TEST(BlackBoxes, AreRefusedAsTheGateSaysOrPassForAReason) {
  const MutationPlan plan = box_plan({"nonstrict~drop:edge_ab", "nonstrict~fma:41", "nonstrict~sign:28",
                                      "nonstrict~clamp:r:0.5", "nonstrict~clamp:r:1e-20"},
                                     192);
  const BlackBoxScore score = judge_black_boxes(plan, wrong_in_exact_arithmetic, never_stopped, {});
  ASSERT_EQ(score.mutants.size(), 5u);
  const auto& [drop, fma, sign, clamp, tiny] =
      std::tie(score.mutants[0], score.mutants[1], score.mutants[2], score.mutants[3], score.mutants[4]);
  for (const BlackBoxResult* refused : {&drop, &clamp}) {
    ASSERT_TRUE(refused->refused) << refused->mutant->id;
    EXPECT_EQ(refused->refused->family, "lattice");
    EXPECT_FALSE(refused->survival);
  }
  for (const BlackBoxResult* passed : {&fma, &sign, &tiny}) {
    EXPECT_FALSE(passed->refused) << passed->mutant->id;
    ASSERT_TRUE(passed->survival) << passed->mutant->id;
    EXPECT_EQ(passed->trials, 192u);
    EXPECT_EQ(passed->survival->queries, 2u * 192);
    EXPECT_EQ(passed->survival->wrong_in_exact, 0u);
  }
  EXPECT_GT(fma.survival->other_verdicts, 0u) << "seed " << box_seed;
  EXPECT_EQ(sign.survival->other_verdicts + tiny.survival->other_verdicts, 0u);
  ASSERT_FALSE(score.controls.empty());
  for (const BlackBoxControl& control : score.controls) EXPECT_FALSE(control.refused) << control.id;
  // A gate that refuses everybody is seen by the kernels that are right.
  const Gate everybody = [](const Record& record) {
    std::vector<GateFailure> failures;
    for (const KernelRecord& kernel : record.kernels)
      failures.push_back({kernel.id, std::string(name(kernel.precision)), "", "all"});
    return failures;
  };
  const BlackBoxScore refused = judge_black_boxes(plan, everybody, never_stopped, {});
  for (const BlackBoxResult& r : refused.mutants) EXPECT_EQ(r.trials, 3u) << "the first round";
  for (const BlackBoxControl& control : refused.controls) EXPECT_TRUE(control.refused) << control.id;
}

}  // namespace
}  // namespace axiscert
