// Wrong verdicts by the class of the input: planted faults land in their class, and no order, filter or round trip
// changes what is counted.
#include "fuzz/campaign/counts/class_tally.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/parts/stretch_testing.h"
#include "fuzz/campaign/parts/tally_code.h"
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/campaign/unit.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

using enum InputClass;

// An exact kernel that is wrong on every input of one class.
Kernel wrong_on(InputClass which) {
  return black_box(
      "wrong",
      [which](const Query<double>& q, std::size_t, Verdict& verdict, std::vector<Finding>&) {
        if (!is_valid(q) || which != class_of(input_classes(q, squared_distance(q)))) return;
        verdict = verdict == Verdict::contact ? Verdict::separated : Verdict::contact;
      },
      "certified");
}

Plan plan_of(const Kernel& kernel, std::vector<std::string> families) {
  Plan plan = small_plan({}, std::move(families), 0);
  plan.answerers.kernels = {&kernel};
  return plan;
}

std::uint64_t wrong(const ClassCount& count) { return count.false_separation + count.false_contact; }

// In binary64, where the query that the planted fault sees is the one that is classified.
TEST(ClassTally, AFaultOnOneClassIsCountedThereAlone) {
  const std::pair<InputClass, const char*> planted[] = {
      {tie, "tie"},           {near_tie, "tangent"}, {scale, "scale"},         {far, "far"},
      {repeated, "repeated"}, {sliver, "sliver"},    {collinear, "collinear"}, {ordinary, "general"}};
  for (const auto& [which, family] : planted) {
    const Kernel kernel = wrong_on(which);
    const Plan plan = plan_of(kernel, {family});
    const Tally tally = run_unit(plan, *plan.questions.sources[0], Precision::binary64, 0, 300).tallies[0];
    const std::uint64_t all = tally.verdict.false_separation + tally.verdict.false_contact;
    EXPECT_GT(all, 10u) << family;
    for (const InputClass each : enumerators<InputClass>) {
      EXPECT_EQ(wrong(tally.classes.classes[each]), each == which ? all : 0)
          << family << ", " << input_class_names[each];
    }
    EXPECT_EQ(tally.classes.first_wrong.size(), all);
  }
}

// A kernel that is often wrong, on queries of every class.
Kernel coarse() {
  return black_box(
      "coarse", [](auto&&...) {}, "published");
}

TEST(ClassTally, AddsUpToTheWrongVerdictsAndKeepsTheDeepest) {
  const Kernel kernel = coarse();
  const Plan plan = plan_of(kernel, {"tangent", "sliver", "repeated", "scale", "tie"});
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : plan.questions.precisions) {
      const Tally tally = run_unit(plan, *source, precision, 0, 1500).tallies[0];
      std::uint64_t sum = 0;
      double deepest = 0;
      for (const ClassCount& count : tally.classes.classes) {
        sum += wrong(count);
        deepest = std::max(deepest, count.deepest.best());
      }
      EXPECT_EQ(sum, tally.verdict.false_separation + tally.verdict.false_contact) << source->name();
      EXPECT_EQ(wrong(tally.classes.classes[tie]), tally.verdict.touching_flips) << source->name();
      EXPECT_EQ(deepest,
                std::max(tally.verdict.deepest_false_separation.best(), tally.verdict.deepest_false_contact.best()));
    }
  }
}

TEST(ClassTally, IsTheSameByExactArithmeticAlone) {
  const Kernel kernel = coarse();
  Plan plan = plan_of(kernel, {"sliver", "scale", "tangent", "far"});
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : plan.questions.precisions) {
      plan.judging.exact_only = false;
      const Tally filtered = run_unit(plan, *source, precision, 0, 600 / TRIAL_DIVISOR).tallies[0];
      plan.judging.exact_only = true;
      const Tally exact = run_unit(plan, *source, precision, 0, 600 / TRIAL_DIVISOR).tallies[0];
      EXPECT_EQ(encode(filtered), encode(exact)) << source->name();
    }
  }
}

TEST(ClassTally, MergesInAnyOrderAndSurvivesARoundTrip) {
  const Kernel kernel = coarse();
  const Plan plan = plan_of(kernel, {"repeated"});
  std::vector<Tally> parts;
  for (std::uint64_t unit = 0; unit < 3; ++unit) {
    parts.push_back(run_unit(plan, *plan.questions.sources[0], Precision::binary32, unit, 900).tallies[0]);
  }
  Tally forward = parts[0], backward = decode_tally(encode(parts[2]), sphere_triangle_predicate());
  forward.merge(parts[1]);
  forward.merge(parts[2]);
  backward.merge(decode_tally(encode(parts[1]), sphere_triangle_predicate()));
  backward.merge(parts[0]);
  EXPECT_EQ(encode(forward), encode(backward));
  EXPECT_GT(forward.classes.first_wrong.size(), 10u);
  EXPECT_LT(std::ranges::max(forward.classes.first_wrong), nearest_queries) << "the first queries only";
}

TEST(ClassTally, AKernelWithAReferenceHasNone) {
  EXPECT_FALSE(has_input_classes(find_kernel("published")));
  EXPECT_FALSE(has_input_classes(find_kernel("minkowski"))) << "a method with links";
  EXPECT_TRUE(has_input_classes(find_kernel("certified")));
  EXPECT_TRUE(has_input_classes(find_kernel("eigen")));
  const Plan plan = small_plan({"published"}, {"repeated"}, 0);
  const Tally tally = run_unit(plan, *plan.questions.sources[0], Precision::binary32, 0, 500).tallies[0];
  EXPECT_GT(tally.verdict.false_contact, 0u);
  for (const ClassCount& count : tally.classes.classes) EXPECT_EQ(wrong(count), 0u);
  EXPECT_TRUE(tally.classes.first_wrong.empty());
}

}  // namespace
}  // namespace axiscert
