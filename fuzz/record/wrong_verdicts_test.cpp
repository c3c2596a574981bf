// Wrong verdicts: the edges of decades and of engine-like queries, the classes of the input, and that a campaign's
// counts add up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/campaign/stretch.h"
#include "fuzz/campaign/stretch_testing.h"
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/record/wrong_verdicts.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

std::uint64_t sum(const DecadeCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

TEST(Decades, BeginAtThePowerOfTenAndEndBelowTheNext) {
  EXPECT_EQ(decade_name(decade_of(0.0)), "zero");
  EXPECT_EQ(decade_name(decade_of(5e-324)), "less");
  EXPECT_EQ(decade_name(decade_of(std::nextafter(1e-20, 0))), "less");
  EXPECT_EQ(decade_name(decade_of(1e-20)), "-20");
  EXPECT_EQ(decade_name(decade_of(std::nextafter(0.1, 0))), "-2");
  EXPECT_EQ(decade_name(decade_of(0.1)), "-1");
  EXPECT_EQ(decade_name(decade_of(std::nextafter(1, 0))), "-1");
  EXPECT_EQ(decade_name(decade_of(1.0)), "0");
  EXPECT_EQ(decade_of(1.0), decade_count - 1);
}

// A depth with bounds; counts how often it is asked for exactly.
class PlantedDepth final : public DepthOf {
 public:
  PlantedDepth(double low, double depth, double high, double threshold)
      : low_(low), depth_(depth), high_(high), threshold_(threshold) {}
  double at_least() override { return low_; }
  double at_most() override { return high_; }
  double exactly() override {
    ++asked;
    return depth_;
  }
  double length() override { return depth_; }
  double length_at_most() override { return high_; }
  bool is_touching() override { return depth_ == 0 && high_ == 0; }
  double engine_threshold() override { return threshold_; }

  int asked = 0;

 private:
  double low_, depth_, high_, threshold_;
};

TEST(Decades, ExactlyOnlyWhereBoundsStraddle) {
  DepthTally depths;
  EngineTally engine;
  PlantedDepth inside(0.02, 0.03, 0.04, 0.01), astride(0.09, 0.1, 0.11, 0.1), below(0.05, 0.06, 0.2, 0.06);
  PlantedDepth touching(0, 0, 0, 0.01), unrepresentable(0, 0, 1e-300, 0.01);
  for (PlantedDepth* depth : {&inside, &astride, &below, &touching, &unrepresentable})
    count_depth(depths, engine, FlipKind::false_contact, *depth);
  EXPECT_EQ(inside.asked, 0);
  EXPECT_GT(astride.asked, 0);
  EXPECT_EQ(depths.false_contact[decade_of(0.02)], 2u);
  EXPECT_EQ(depths.false_contact[decade_of(0.1)], 1u) << "the exact depth decides, not a bound";
  EXPECT_EQ(sum(engine.wrong.false_contact), 1u) << "a depth at the threshold is not above it";
  EXPECT_EQ(depths.false_contact[0], 1u) << "spheres that touch alone";
  EXPECT_EQ(depths.false_contact[1], 1u);
  EXPECT_EQ(unrepresentable.asked, 0) << "below all decades, whether or not a double holds it";
  EXPECT_EQ(sum(depths.false_separation), 0u);
}

template <class Real>
class EngineLike : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(EngineLike, Reals);

TYPED_TEST(EngineLike, EveryNumberHasToBe) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  const Query<Real> good{{1, 0, -2}, {Limits::min(), 3, 4}, {5, 6, 0x1p20f}, {-0.0f, 1, 1}, 0x1p-20f};
  EXPECT_TRUE(is_engine_like(good));
  for (std::size_t i = 0; i + 1 < coordinate_count; ++i) {
    for (const Real bad : {Limits::quiet_NaN(), Limits::infinity(), Limits::denorm_min(), Real(0x1.000002p20f)}) {
      auto numbers = coordinates(good);
      numbers[i] = bad;
      EXPECT_FALSE(is_engine_like(from_coordinates(numbers))) << i << " " << bad;
    }
  }
  for (const Real bad : {Real(0), Real(-1), Real(0x1.fffffep-21f), Real(0x1.000002p20f), Limits::quiet_NaN()}) {
    Query<Real> q = good;
    q.r = bad;
    EXPECT_FALSE(is_engine_like(q)) << bad;
  }
}

// The counts of a unit by columns are those of its queries one by one; decades add up to the wrong verdicts; no filter
// changes a count.
TYPED_TEST(EngineLike, CountsOfAUnitAddUp) {
  using Real = TypeParam;
  constexpr std::uint64_t size = 1500;
  Plan plan;
  plan.answerers.kernels = {&find_kernel("first-publication"), &find_kernel("published")};
  plan.running.target = resolve_target("auto");
  for (const char* name : {"tangent", "scale", "tie", "bits"}) {
    const SourcePtr source = family_source(find_family(name));
    std::uint64_t engine_like = 0;
    for (std::uint64_t i = 0; i < size; ++i) {
      const Numbers<Real> numbers = find_family(name).make<Real>(plan.questions.seed, i);
      std::array<Real, coordinate_count> all;
      for (std::size_t k = 0; k < coordinate_count; ++k) all[k] = numbers[k];
      engine_like += is_engine_like(from_coordinates(all));
    }
    plan.judging.exact_only = false;
    const auto quick = run_unit(plan, *source, precision_of<Real>, 0, size).tallies;
    plan.judging.exact_only = true;
    const auto exact = run_unit(plan, *source, precision_of<Real>, 0, size).tallies;
    for (std::size_t k = 0; k < quick.size(); ++k) {
      const VerdictTally& verdict = quick[k].verdict;
      EXPECT_EQ(sum(verdict.depths->false_separation), verdict.false_separation) << name;
      EXPECT_EQ(sum(verdict.depths->false_contact), verdict.false_contact) << name;
      std::uint64_t deep = 0;
      for (std::size_t d = decade_of(1e-3); d < decade_count; ++d)
        deep += verdict.depths->false_separation[d] + verdict.depths->false_contact[d];
      EXPECT_EQ(verdict.depths->deep, deep) << name;
      EXPECT_EQ(verdict.depths, exact[k].verdict.depths) << name;
      EXPECT_EQ(verdict.engine->wrong, exact[k].verdict.engine->wrong) << name;
      EXPECT_EQ(verdict.engine->queries, engine_like) << name;
      EXPECT_EQ(exact[k].verdict.engine->queries, engine_like) << name;
      EXPECT_EQ(verdict.engine->decided(), engine_like) << name;
      EXPECT_EQ(verdict.engine->decided_contacts, exact[k].verdict.engine->decided_contacts) << name;
      EXPECT_EQ(verdict.decided_touching, exact[k].verdict.decided_touching) << name;
      EXPECT_EQ(quick[k].with_signs, exact[k].with_signs) << name;
      EXPECT_EQ(quick[k].with_signs, verdict.decided()) << name << ": every answer has comparisons";
      EXPECT_LE(sum(verdict.engine->wrong.false_contact), verdict.false_contact) << name;
    }
  }
}

}  // namespace

// Wrong verdicts by the class of the input: planted faults land in their class, and no order, filter or round trip
// changes what is counted.

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
  const Kernel declines = black_box(
      "declines",
      [](const auto& q, std::size_t, Verdict& verdict, auto&) {
        if (q.a.x > 0) verdict = Verdict::undecided;
      },
      "published");
  Kernel limited = coarse();
  limited.limits = {.least_coordinate = 0x1p-15, .greatest_coordinate = 0x1p15};
  for (const Kernel& kernel : {coarse(), declines, limited}) {
    Plan plan = plan_of(kernel, {"sliver", "scale", "tangent", "far", "tie"});
    for (const SourcePtr& source : plan.questions.sources) {
      for (const Precision precision : plan.questions.precisions) {
        plan.judging.exact_only = false;
        const Tally filtered = run_unit(plan, *source, precision, 0, 600 / TRIAL_DIVISOR).tallies[0];
        plan.judging.exact_only = true;
        const Tally exact = run_unit(plan, *source, precision, 0, 600 / TRIAL_DIVISOR).tallies[0];
        EXPECT_EQ(encode(filtered), encode(exact)) << kernel.id << " on " << source->name();
        EXPECT_EQ(filtered.verdict.undecided != 0, kernel.id == "declines") << source->name();
      }
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
