// Mutants of the twenty axes: named by what they change, and caught by the families of moving-sphere.
#include <gtest/gtest.h>

#include <algorithm>

#include "fuzz/mutation/mutation.h"
#include "fuzz/queries/entry_families.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::uint64_t motion_mutants_seed = 7;
constexpr std::string_view twenty = mutants::bases[2];
const std::atomic<bool> goes_on = false;

MutationPlan motion_mutants(std::size_t stride, std::uint64_t trials, std::string_view fault = "") {
  MutationPlan plan{{},     std::string(twenty), {}, {Precision::binary32, Precision::binary64},
                    trials, motion_mutants_seed, 2};
  std::size_t i = stride / 2;
  for (const mutants::Mutant& m : mutants::mutants_of(twenty)) {
    if (!fault.empty() && m.fault != fault) continue;
    if (i++ % stride == 0) plan.mutants.push_back(&m);
  }
  plan.families = families_of(*find_kernel(twenty).predicate, 0);
  return plan;
}

TEST(MotionMutants, AreOfEveryOperationComparisonAndAxis) {
  const auto all = mutants::mutants_of(twenty);
  const auto count = [&](std::string_view fault) {
    return std::count_if(all.begin(), all.end(), [&](const mutants::Mutant& m) { return m.fault == fault; });
  };
  EXPECT_EQ(count("strictness"), 61);
  EXPECT_EQ(count("reverse"), 61);
  EXPECT_EQ(count("drop"), 20);
  EXPECT_GE(count("operator"), 300);
  EXPECT_EQ(mutants::find_mutant(std::string(twenty) + "~operator:0").where, "0: ax - px");
  EXPECT_EQ(mutants::kernel_of(all.front()).predicate, &find_predicate("moving-sphere"));
  EXPECT_THROW(mutants::mutants_of("moving-sphere/twenty"), Error) << "strict sides are wrong over the reals";
}

// Every 149th: all are caught; those that round as the base does by their claim of formulae alone too.
TEST(MotionMutants, ASampleIsCaught) {
  const MutationResult result = run_mutation(motion_mutants(149, 1500), goes_on, {});
  EXPECT_GE(result.mutants.size(), 30u);
  for (const MutantResult& r : result.mutants) {
    if (equivalent_mutants().contains(r.mutant->id)) continue;
    EXPECT_TRUE(r.by_bits) << r.mutant->id << ' ' << r.mutant->where << ' ' << name(r.precision) << " seed "
                           << motion_mutants_seed;
  }
}

TEST(MotionMutants, AKernelThatIsRightIsNeverFlagged) {
  for (const Control& c : run_controls(motion_mutants(1, 0, "none"), 8, goes_on))
    EXPECT_EQ(c.flagged, 0u) << c.id << ' ' << name(c.precision) << " seed " << motion_mutants_seed;
}

}  // namespace
}  // namespace axiscert
