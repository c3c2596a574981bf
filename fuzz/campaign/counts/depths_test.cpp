// Decades of depth and engine-like queries: their edges, and that a campaign's counts add up.
#include "fuzz/campaign/counts/depths.h"

#include "exact/sphere_triangle/measures/engine_like.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "fuzz/campaign/unit.h"

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
      EXPECT_LE(sum(verdict.engine->wrong.false_contact), verdict.false_contact) << name;
    }
  }
}

}  // namespace
}  // namespace axiscert
