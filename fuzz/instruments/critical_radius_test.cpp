// Distributions of critical radii: kernels known to be monotone, and a planted one that is not.
#include "fuzz/instruments/critical_radius.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "fuzz/queries/family.h"
#include "exact/judge/oracles.h"
#include "fuzz/instruments/instruments_testing.h"
#include "fuzz/files/query_file.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

CriticalRadiusPlan radius_plan(std::vector<const Kernel*> kernels, std::vector<std::string_view> families) {
  CriticalRadiusPlan plan;
  plan.kernels = std::move(kernels);
  for (const auto name : families) plan.sources.push_back(family_source(find_family(name)));
  plan.trials = 600;
  return plan;
}

void expect_consistent(const CriticalRadii& cell) {
  EXPECT_EQ(cell.measured, cell.right + cell.early + cell.late + cell.unbounded);
  EXPECT_EQ(cell.within({}), cell.right) << "no error is the exact critical radius, and nothing else";
  EXPECT_EQ(cell.worst_early.has_value(), cell.early > 0);
  EXPECT_EQ(cell.worst_late.has_value(), cell.late > 0);
}

TEST(CriticalRadiusInstrument, MonotoneKernelsAreNotAccused) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    auto plan = radius_plan({&find_kernel("published"), &find_kernel("minkowski")}, {"general", "sliver", "scale"});
    plan.precision = precision;
    plan.trials = precision == Precision::binary32 ? 600 : 100;
    for (const auto& by_family : measure_critical_radii(plan).cells) {
      for (const CriticalRadii& cell : by_family) {
        expect_consistent(cell);
        EXPECT_EQ(cell.measured, plan.trials);
        EXPECT_EQ(cell.reversals, 0u);
      }
      EXPECT_LE(by_family[0].quantile(0.5)->value(), 1) << "general triangles: within a float of the truth";
    }
  }
}

TEST(CriticalRadiusInstrument, ATriangleOnWhichSomeRadiusIsNotDecidedIsNotMeasured) {
  for (const Verdict said : {Verdict::undecided, Verdict::invalid, Verdict::unanswered}) {
    const Kernel kernel = saying(said, false);
    const CriticalRadii cell = measure_critical_radii(radius_plan({&kernel}, {"general"})).cells[0][0];
    EXPECT_EQ(cell.measured, 0u) << name(said);
    EXPECT_EQ(said == Verdict::undecided ? cell.undecided
              : said == Verdict::invalid ? cell.invalid
                                         : cell.unanswered,
              600u);
  }
}

TEST(CriticalRadiusInstrument, OutsideTheLimitsNothingIsMeasured) {
  Kernel limited = find_kernel("published");
  limited.limits.least_radius = 0.5;
  limited.limits.greatest_radius = 2;
  const CriticalRadii cell = measure_critical_radii(radius_plan({&limited}, {"general"})).cells[0][0];
  EXPECT_GT(cell.measured, 0u);
  EXPECT_GT(cell.outside_limits, 0u);
  EXPECT_EQ(cell.measured + cell.outside_limits, 600u);
  EXPECT_EQ(cell.unbounded, 0u) << "the greatest radius that is asked is within the limits";
}

TEST(CriticalRadiusInstrument, APlantedGapIsFoundOnEveryTriangleWithAValidPair) {
  const Kernel planted = published_with_a_gap();
  const auto plan = radius_plan({&planted}, {"general"});
  const CriticalRadii cell = measure_critical_radii(plan).cells[0][0];
  expect_consistent(cell);
  EXPECT_EQ(cell.reversals, cell.measured);
  ASSERT_TRUE(cell.first_reversal);
  EXPECT_EQ(cell.first_reversal->position, 0u);
  const auto stored =
      parse_queries(cell.first_reversal->contact + "\n" + cell.first_reversal->separated, "witness", plan.precision);
  ASSERT_EQ(stored.size(), 2u);
  QueryBatch<float> batch(2, coordinate_count);
  for (const StoredQuery& query : stored) batch.push_back(sphere_triangle_query_in<float>(query));
  EXPECT_LT(query_from(batch[0]).r, query_from(batch[1]).r);
  Verdict verdicts[2];
  planted.on<float>(scalar_target).verdicts(batch.columns(), verdicts);
  EXPECT_EQ(verdicts[0], Verdict::contact);
  EXPECT_EQ(verdicts[1], Verdict::separated);
}

TEST(CriticalRadiusInstrument, InvalidQueriesAndDistancesBeyondThePrecisionAreLeftOut) {
  const auto plan = radius_plan({&find_kernel("published")}, {"nonfinite"});
  const CriticalRadiusResult result = measure_critical_radii(plan);
  EXPECT_EQ(result.left_out[0] + result.cells[0][0].measured, plan.trials);
  EXPECT_GT(result.left_out[0], 0u);
}

// The half extent of A's first axis at which the boxes touch: rational. Kernels are monotone in it, since rounding is.
TEST(CriticalRadiusInstrument, MeasuresTheHalfExtentAtWhichTwoBoxesTouch) {
  const auto squared = [](const Numbers<double>& q) {
    return oracles_of(find_predicate("box-box")).critical_length()->squared(q);
  };
  Numbers<double> cubes = {0, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, 3.5, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  EXPECT_EQ(squared(cubes), Rational(25, 4));
  cubes[15] = 0.5;
  EXPECT_EQ(squared(cubes), 0) << "in contact with any";
  cubes[16] = 2.5;
  EXPECT_FALSE(squared(cubes)) << "apart along y, whatever the extent along x";
  cubes[6] = 0;
  EXPECT_FALSE(squared(cubes)) << "no box";
  for (const auto& [id, family] :
       {std::pair{"box-box/cofactor", "box-box/general"}, std::pair{"box-box/homogeneous", "box-box/general_turned"}}) {
    auto plan = radius_plan({&find_kernel(id)}, {family});
    plan.trials = 150;
    const CriticalRadii cell = measure_critical_radii(plan).cells[0][0];
    expect_consistent(cell);
    EXPECT_GT(cell.measured, 100u) << id;
    EXPECT_EQ(cell.reversals, 0u) << id;
    EXPECT_GT(cell.within(round_up(Rational(64))), cell.measured * 9 / 10) << id;
  }
}

// The least distance of the motion, from which the static instrument's measures follow.
TEST(CriticalRadiusInstrument, MeasuresAMovingSphereFromTheLeastDistanceOfItsMotion) {
  auto plan =
      radius_plan({&find_kernel("moving-sphere/twenty-nonstrict"), &find_kernel("moving-sphere/advance-by-length")},
                  {"moving-sphere/general", "moving-sphere/slide"});
  plan.trials = 60;
  const CriticalRadiusResult result = measure_critical_radii(plan);
  for (const auto& by_family : result.cells) {
    for (const CriticalRadii& cell : by_family) {
      expect_consistent(cell);
      EXPECT_EQ(cell.measured, plan.trials);
    }
  }
  EXPECT_LE(result.cells[0][0].quantile(0.5)->value(), 2) << "general motions: within some floats of the truth";
  EXPECT_GT(result.cells[1][1].late, 0u) << "steps by |D| alone end before a motion along the face does";
  // A static query has the same critical radius as its motion by 0.
  const Numbers<double> still = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3, 0, 0, 0, 0};
  EXPECT_EQ(oracles_of(moving_sphere_predicate()).critical_length()->squared(still), 9);
  EXPECT_EQ(oracles_of(moving_sphere_predicate()).critical_length()->column, 15u);
}

TEST(CriticalRadiusInstrument, DoesNotDependOnThreads) {
  const Kernel planted = published_with_a_gap();
  const auto plan = radius_plan({&planted, &find_kernel("ladder-0+prescaled")}, {"repeated", "ratio"});
  std::vector<CriticalRadiusResult> results;
  for (const std::size_t threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(measure_critical_radii(plan));
  }
  EXPECT_TRUE(results[0] == results[1]);
}

}  // namespace
}  // namespace axiscert
