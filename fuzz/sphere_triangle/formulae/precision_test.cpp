// Evaluation at any precision: the scalar reference's bits if the formats agree, no flip if there are enough bits, and
// tallies that depend on the plan alone.
#include "fuzz/sphere_triangle/formulae/precision.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <bit>
#include <limits>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/unbounded.h"
#include "exact/sphere_triangle/degree.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
class AtPrecisionTest : public testing::Test {};
TYPED_TEST_SUITE(AtPrecisionTest, Reals);

constexpr std::array<Strictness, 3> strictnesses = {Strictness::strict, Strictness::nonstrict, Strictness::not_less};

// Families in which most operations leave the range get the greater number of queries.
template <class Real, class Check>
void for_each_family(std::uint64_t few, std::uint64_t many, Check&& check) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    const bool at_the_ends = family->name == "bits" || family->name == "subnormal" || family->name == "scale";
    for_each_query<Real>(family->name, at_the_ends ? many : few, check);
  }
}

TYPED_TEST(AtPrecisionTest, TheFormatsOwnBitsAndExponentsGiveTheScalarReference) {
  constexpr int digits = std::numeric_limits<TypeParam>::digits;
  for_each_family<TypeParam>(100, 1200, [](const Query<TypeParam>& q, std::uint64_t position) {
    const Strictness strictness = strictnesses[position % 3];
    for (std::size_t i = 0; i < formulae_count; ++i) {
      const auto formulae = static_cast<Formulae>(i);
      const Outcome reference = axiscert::reference(formulae, Arithmetic::plain, strictness, q);
      EXPECT_EQ(at_precision(formulae, strictness, q, digits, precision_of<TypeParam>), reference) << name(formulae);
    }
  });
}

TYPED_TEST(AtPrecisionTest, UnlimitedExponentsGiveTheUnboundedEvaluation) {
  constexpr int digits = std::numeric_limits<TypeParam>::digits;
  for_each_family<TypeParam>(60, 200, [](const Query<TypeParam>& q, std::uint64_t position) {
    const Strictness strictness = strictnesses[position % 3];
    for (std::size_t i = 0; i < formulae_count; ++i) {
      const auto formulae = static_cast<Formulae>(i);
      EXPECT_EQ(at_precision(formulae, strictness, q, digits, std::nullopt),
                unbounded(formulae, Arithmetic::plain, strictness, q))
          << name(formulae);
    }
  });
}

TYPED_TEST(AtPrecisionTest, WhatIsLeftOutWouldRepeat) {
  for_each_family<TypeParam>(20, 100, [](const Query<TypeParam>& q, std::uint64_t position) {
    for (const int bits : {8, 24, 53, 113}) {
      const auto formulae = static_cast<Formulae>(position % formulae_count);
      const BothRanges both =
          in_both_ranges(formulae, Strictness::strict, q, {bits, Rounding::nearest, precision_of<TypeParam>});
      EXPECT_EQ(both.unlimited, at_precision(formulae, Strictness::strict, q, bits, std::nullopt));
      EXPECT_EQ(both.limited, at_precision(formulae, Strictness::strict, q, bits, precision_of<TypeParam>));
    }
  });
}

// Planted: one bit fewer than the format has.
TYPED_TEST(AtPrecisionTest, OneBitLessIsSeenOnTangent) {
  constexpr int digits = std::numeric_limits<TypeParam>::digits;
  int differences = 0, more_flips = 0;
  for_each_query<TypeParam>("tangent", 2000, [&](const Query<TypeParam>& q, std::uint64_t) {
    const auto exact = exact_sides(q).strict;
    const auto bits_at = [&](int bits) {
      return *at_precision(Formulae::published, Strictness::strict, q, bits, precision_of<TypeParam>).bits;
    };
    const auto full = bits_at(digits), less = bits_at(digits - 1);
    differences += less != full;
    more_flips +=
        std::popcount(static_cast<unsigned>(less ^ exact)) - std::popcount(static_cast<unsigned>(full ^ exact));
  });
  EXPECT_GT(differences, 50);
  EXPECT_GT(more_flips, 10);
}

// The least b for which all coordinates and the radius are integers of b bits after multiplication by a power of two.
template <class Real>
int integer_bits(const Query<Real>& q) {
  int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
  for (const Real x : coordinates(q)) {
    if (x == 0) continue;
    const Rational value = exact(static_cast<double>(std::abs(x)));
    const auto bits = [](const mpz_class& n) { return static_cast<int>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
    const int denominator = bits(value.get_den()) - 1;  // a power of two
    lowest = std::min(lowest, static_cast<int>(mpz_scan1(value.get_num_mpz_t(), 0)) - denominator);
    highest = std::max(highest, bits(value.get_num()) - denominator);
  }
  return lowest > highest ? 1 : highest - lowest;
}

template <class Real>
void expect_no_flip_at_the_bit_length(const char* family, std::uint64_t queries) {
  int comparisons_checked = 0;
  for_each_query<Real>(family, queries, [&](const Query<Real>& q, std::uint64_t position) {
    const auto formulae = static_cast<Formulae>(position % formulae_count);
    const auto degrees = degrees_of(formulae);
    if (!degrees) return;
    const ComparisonBits exact = exact_sides(formulae, q).strict;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      if (!(*degrees)[k].bits) continue;
      const int bits = std::max(least_bits, (*degrees)[k].bits->at(integer_bits(q)));
      ASSERT_LE(bits, greatest_bits);
      const Outcome found = at_precision(formulae, Strictness::strict, q, bits, std::nullopt);
      EXPECT_EQ(has_bit(*found.bits, k), has_bit(exact, k)) << name(formulae) << " " << comparisons[k].name;
      ++comparisons_checked;
    }
  });
  EXPECT_GT(comparisons_checked, 1000) << family;
}

// Large ties of binary64 need 6 * 53 + 19 bits, which is beyond the greatest supported number.
TEST(AtPrecision, IntegersDoNotFlipAtTheRecordedBitLength) {
  expect_no_flip_at_the_bit_length<float>("lattice", 1000);
  expect_no_flip_at_the_bit_length<double>("lattice", 1000);
  expect_no_flip_at_the_bit_length<float>("tie", 1000);
}

PrecisionPlan plan_of(std::vector<const char*> kernels, std::vector<const char*> families, std::uint64_t trials) {
  PrecisionPlan plan;
  plan.trials = trials;
  for (const char* id : kernels) plan.kernels.push_back(&find_kernel(id));
  for (const char* family : families) plan.sources.push_back(family_source(find_family(family)));
  for (const int bits : {8, 16, 24, 53, 256}) plan.numbers.push_back(format_of_bits(bits));
  return plan;
}

// What bits beyond 80 are for, on thin triangles and on those without area.
TEST(AtPrecision, FromEightyBitsOnOnlyExactTiesFlip) {
  std::array<int, 2> flips_of_ties{};
  for (const char* name : {"sliver", "collinear"}) {
    for (std::uint64_t position = 0; position < 200; ++position) {
      const auto q = Query<float>::from(find_family(name).make<float>(1, position));
      const ExactSides exact = exact_sides(q);
      for (const int bits : {80, 160}) {
        const Outcome found = at_precision(Formulae::published, Strictness::strict, q, bits, std::nullopt);
        const auto flips = static_cast<SignBits>(*found.bits ^ exact.strict);
        EXPECT_EQ(flips & ~exact.ties, 0) << name << ' ' << position << ", " << bits << " bits";
        flips_of_ties[bits == 160] += std::popcount(flips);
      }
    }
  }
  EXPECT_GT(flips_of_ties[0], 50);
  EXPECT_EQ(flips_of_ties[1], 0);
}

TEST(MeasurePrecision, ThreadsChangeNothing) {
  const PrecisionPlan plan = plan_of({"ladder-0", "ladder-9", "reduced", "minkowski"}, {"tangent", "scale"}, 300);
  std::vector<std::vector<PrecisionTally>> found;
  for (const std::size_t threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    found.push_back(measure_precision(plan));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

TEST(MeasurePrecision, TellsRoundingFromRangeAndBothFromTheFormulae) {
  const PrecisionPlan plan =
      plan_of({"ladder-9", "reduced", "nonstrict"}, {"tangent", "scale", "lattice", "nonfinite"}, 600);
  const auto found = measure_precision(plan);
  const std::size_t at_24 = 2, at_256 = 4;
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    const KernelPrecision &tangent = found[0].kernels[k], &scale = found[1].kernels[k], &lattice = found[2].kernels[k];
    EXPECT_GT(tangent.steps[0].rounding, tangent.steps[at_24].rounding);
    EXPECT_GT(tangent.steps[at_24].rounding, 0u);
    EXPECT_EQ(tangent.steps[at_24].range, 0u);
    EXPECT_EQ(scale.steps[at_24].rounding, 0u);
    EXPECT_GT(scale.steps[at_24].range, 100u);
    EXPECT_GT(scale.steps[at_256].range, 100u) << "no number of bits mends a range";
    EXPECT_EQ(lattice.steps[at_256].in(ExponentRange::unlimited).verdict, lattice.exact);
  }
  EXPECT_GT(found[2].kernels[0].exact.false_contact, 0u) << "strict sides on degenerate triangles";
  EXPECT_EQ(found[2].kernels[0].exact, found[2].kernels[1].exact) << "published and reduced agree in exact arithmetic";
  EXPECT_EQ(found[2].kernels[2].exact.total(), 0u);
  EXPECT_LT(found[3].queries, plan.trials) << "invalid queries are not counted";
}

TEST(MeasurePrecision, SufficientBitsAreTheLastRunWithoutAFlip) {
  PrecisionPlan plan = plan_of({"published"}, {}, 1);
  KernelPrecision kernel;
  kernel.steps.resize(plan.step_count());
  for (PrecisionStep& step : kernel.steps) step.queries = 1;
  const auto side_c = index_of(Comparison::vertex_a_side_c);
  auto& flips = kernel.steps[1].unlimited;
  flips.comparisons[side_c] = 1;
  flips.verdict.false_contact = 1;
  kernel.steps[3].limited.comparisons[side_c] = 1;  // limited exponents do not count
  kernel.steps[3].rounding = 1;
  EXPECT_EQ(sufficient_bits(plan, kernel, one_bit<ComparisonBits>(side_c)), 24);
  EXPECT_EQ(sufficient_bits(plan, kernel, one_bit<ComparisonBits>(side_c + 1)), 8);
  EXPECT_EQ(sufficient_verdict_bits(plan, kernel).verdict, 24);
  EXPECT_EQ(sufficient_verdict_bits(plan, kernel).own_verdict, 256);
  kernel.steps[2].queries = 0;
  EXPECT_EQ(sufficient_bits(plan, kernel, one_bit<ComparisonBits>(side_c + 1)), 53) << "of 24 bits nothing is known";
  kernel.steps[4].unlimited.comparisons[side_c] = 1;
  EXPECT_EQ(sufficient_bits(plan, kernel, one_bit<ComparisonBits>(side_c)), std::nullopt);
  for (PrecisionStep& step : kernel.steps) step = {};
  EXPECT_EQ(sufficient_bits(plan, kernel, one_bit<ComparisonBits>(side_c)), std::nullopt) << "0 flips of 0 queries";
  EXPECT_EQ(sufficient_verdict_bits(plan, kernel).verdict, std::nullopt);
}

TEST(MeasurePrecision, AnotherArithmeticIsRefused) {
  EXPECT_THROW(measure_precision(plan_of({"published+fma"}, {"general"}, 1)), Error);
}

// Directed and fused operations in the queries' own format are compared with the scalar reference on every query.
TEST(MeasurePrecision, InTheOwnFormatEveryRuleIsTheReference) {
  for (const RoundingRule rule : enumerators<RoundingRule>) {
    for (const Contraction contraction : {Contraction::none, Contraction::dots}) {
      PrecisionPlan plan = plan_of({"ladder-0", "ladder-9"}, {"tangent", "scale"}, 200);
      plan.numbers = {parse_number_format("binary32"), parse_number_format("bits=24")};
      plan.rounding = rule;
      plan.contraction = contraction;
      const auto found = measure_precision(plan);
      for (const PrecisionTally& family : found) {
        for (const KernelPrecision& kernel : family.kernels) {
          ASSERT_EQ(kernel.steps.size(), 2u);
          EXPECT_EQ(kernel.steps[0].limited, kernel.steps[1].limited) << name(rule);
        }
      }
    }
  }
  PrecisionPlan variant = plan_of({"minkowski"}, {"general"}, 1);
  variant.contraction = Contraction::dots;
  EXPECT_THROW(measure_precision(variant), Error);
}

TEST(MeasurePrecision, ChanceIsReproducibleAndSeedsDiffer) {
  PrecisionPlan plan = plan_of({"ladder-0", "ladder-9"}, {"tangent"}, 400);
  plan.numbers = {parse_number_format("binary16"), parse_number_format("tf32")};
  plan.rounding = RoundingRule::stochastic;
  plan.rounding_seeds = 3;
  std::vector<std::vector<PrecisionTally>> found;
  for (const std::size_t threads : {1, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    found.push_back(measure_precision(plan));
  }
  EXPECT_EQ(found[0], found[1]);
  const KernelPrecision& kernel = found[0][0].kernels[0];
  ASSERT_EQ(kernel.steps.size(), 6u);
  EXPECT_NE(kernel.steps[0], kernel.steps[1]);
  EXPECT_NE(kernel.steps[1], kernel.steps[2]);
  EXPECT_EQ(plan.seed_of(4), 2u);
  EXPECT_EQ(plan.number_of(4).name, "tf32");
}

// A query that is rounded first is another query, with its own truth; in a format that has all of its numbers nothing
// changes.
TEST(MeasurePrecision, RoundedInputsAreJudgedAsWhatTheyHaveBecome) {
  PrecisionPlan plan = plan_of({"nonstrict"}, {"tangent", "far"}, 300);
  plan.numbers = {parse_number_format("binary16"), parse_number_format("binary32")};
  const auto taken = measure_precision(plan);
  plan.round_inputs = true;
  const auto rounded = measure_precision(plan);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(taken[s].kernels[0].steps[1], rounded[s].kernels[0].steps[1]);
    EXPECT_NE(taken[s].kernels[0].steps[0], rounded[s].kernels[0].steps[0]);
    EXPECT_EQ(rounded[s].kernels[0].steps[0].exact.total(), 0u) << "the truth is that of the rounded query";
  }
  EXPECT_EQ(rounded[0].kernels[0].steps[0].queries, rounded[0].queries);
  EXPECT_LT(rounded[1].kernels[0].steps[0].queries, rounded[1].queries) << "10^5 is beyond binary16";
}

}  // namespace
}  // namespace axiscert
