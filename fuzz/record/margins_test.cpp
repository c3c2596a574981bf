// Margins: the exponents are those of rational arithmetic, and no finite comparison is wrong above its largest error.
#include "fuzz/record/margins.h"
#include "fuzz/text/json_form.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "fuzz/campaign/campaign.h"

namespace axiscert {
namespace {

template <class Real>
std::optional<int> exponent(const BinaryNumber& lhs, const BinaryNumber& rhs, bool rooted = false,
                            bool undefined = false) {
  return margin_exponent<Real>(ExactComparison{BinaryFraction(lhs), BinaryFraction(rhs), rooted, undefined});
}

// By definition, over the rationals: the k with 2^k < |l - r| / (u (|l| + |r|)) <= 2^(k+1).
int by_definition(const Rational& l, const Rational& r, int digits) {
  if (l == r) return tied_margin;
  Rational margin = abs(Rational(l - r)) / (abs(l) + abs(r)) * Rational(mpz_class(1) << digits);
  int k = 0;
  for (; margin > 2; margin /= 2) ++k;
  for (; margin <= 1; margin *= 2) --k;
  return std::max(k, least_margin_exponent);
}

TEST(MarginExponent, IsThatOfTheDefinitionOnWholeNumbers) {
  constexpr std::uint64_t seed = 20261122;
  std::mt19937_64 random(seed);
  const auto number = [&] {
    const auto bits = static_cast<int>(random() % 50);
    return static_cast<double>(static_cast<std::int64_t>(random() >> (63 - bits)) * (random() % 2 == 0 ? 1 : -1));
  };
  for (int i = 0; i < 20000; ++i) {
    const double l = number(), r = i % 3 == 0 ? l + static_cast<double>(random() % 3) - 1 : number();
    ASSERT_EQ(exponent<float>(BinaryNumber(l), BinaryNumber(r)), by_definition(l, r, 24))
        << l << " " << r << " of seed " << seed;
    ASSERT_EQ(exponent<double>(BinaryNumber(l), BinaryNumber(r)), by_definition(l, r, 53))
        << l << " " << r << " of seed " << seed;
  }
}

// Margins for which no estimate can decide on which side of a power of two they lie.
TEST(MarginExponent, APowerOfTwoBelongsToTheBinBelow) {
  EXPECT_EQ(exponent<float>(BinaryNumber(1), BinaryNumber(-1)), 23);  // 1/u: no margin is greater
  EXPECT_EQ(exponent<double>(BinaryNumber(1), BinaryNumber()), 52);
  for (int k = 1; k < 24; ++k) {
    const double part = std::ldexp(1.0, -k);  // (1 + p) - (1 - p) over the sum: p
    EXPECT_EQ(exponent<float>(BinaryNumber(1 + part), BinaryNumber(1 - part)), 23 - k);
    EXPECT_EQ(exponent<float>(BinaryNumber(std::ldexp(1 + part, -700)), BinaryNumber(std::ldexp(1 - part, -700))),
              23 - k);
  }
}

TEST(MarginExponent, TiesUndefinedSidesAndTheLeast) {
  EXPECT_EQ(exponent<float>(BinaryNumber(3), BinaryNumber(3)), tied_margin);
  EXPECT_EQ(exponent<float>(BinaryNumber(), BinaryNumber()), tied_margin);
  EXPECT_EQ(exponent<float>(BinaryNumber(), BinaryNumber(), false, true), std::nullopt);
  EXPECT_EQ(exponent<float>(BinaryNumber(1), BinaryNumber(1 + 0x1p-50)), least_margin_exponent);
  EXPECT_EQ(exponent<double>(BinaryNumber(1), BinaryNumber(1 + 0x1p-50)), 1);
}

TEST(MarginExponent, OfARootIsThatOfItsValue) {
  EXPECT_EQ(exponent<float>(BinaryNumber(9), BinaryNumber(1), true), exponent<float>(BinaryNumber(3), BinaryNumber(1)));
  EXPECT_EQ(exponent<float>(BinaryNumber(9), BinaryNumber(-3), true), 23);
  EXPECT_EQ(exponent<float>(BinaryNumber(9), BinaryNumber(3), true), tied_margin);
  EXPECT_EQ(exponent<float>(BinaryNumber(), BinaryNumber(), true), tied_margin);
  // sqrt(2) - 1.4142135 is 6.2e-8: 2.2e-8 of the scale, 0.37 u.
  EXPECT_EQ(exponent<float>(BinaryNumber(2), BinaryNumber(1.4142135), true), -2);
  // Beyond binary64's range: only exact arithmetic decides.
  BinaryNumber huge(1);
  for (int i = 0; i < 3; ++i) huge = huge * BinaryNumber(0x1p+500);
  EXPECT_EQ(exponent<float>(huge * huge * BinaryNumber(9), huge, true), 22);
}

Plan plan_of(const std::string& kernel, bool exact_only) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel(kernel)};
  for (const char* name : {"general", "tangent", "sliver", "tie", "scale"})
    plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.running.target = exact_only ? std::string(scalar_target) : resolve_target("auto");
  plan.judging.exact_only = exact_only;
  return plan;
}

std::string counts_text(const Tally& tally) {
  std::string text;
  for (const auto& [name, comparison] : tally.comparisons) text += name + json_of(comparison.margins).dump() + "\n";
  return text;
}

constexpr std::uint64_t asked = margin_queries + 40;

TEST(Margins, AreOfTheFirstQueriesOfEachSourceAlone) {
  const Plan plan = plan_of("published", false);
  const UnitResult whole = run_unit(plan, *plan.questions.sources[1], Precision::binary32, 0, asked),
                   first = run_unit(plan, *plan.questions.sources[1], Precision::binary32, 0, margin_queries),
                   next = run_unit(plan, *plan.questions.sources[1], Precision::binary32, 1, 40);
  EXPECT_EQ(counts_text(whole.tallies[0]), counts_text(first.tallies[0]));
  for (const auto& [name, comparison] : next.tallies[0].comparisons) EXPECT_EQ(comparison.margins, MarginTally());
  for (const auto& [name, comparison] : whole.tallies[0].comparisons) {
    std::uint64_t measured = 0;
    for (const auto& [exponent, count] : comparison.margins.right.by_exponent) measured += count;
    for (const auto& [exponent, count] : comparison.margins.wrong.by_exponent) measured += count;
    EXPECT_EQ(measured, margin_queries) << name;
  }
}

TEST(Margins, AreTheSameWithoutFilters) {
  for (const char* kernel : {"published", "ladder-0"}) {
    const Plan fast = plan_of(kernel, false), slow = plan_of(kernel, true);
    const UnitResult x = run_unit(fast, *fast.questions.sources[2], Precision::binary32, 0, 64),
                     y = run_unit(slow, *slow.questions.sources[2], Precision::binary32, 0, 64);
    EXPECT_EQ(counts_text(x.tallies[0]), counts_text(y.tallies[0])) << kernel;
  }
}

// A wrong sign needs an error of at least the margin: the largest measured error bounds the margins of counted wrong
// signs.
TEST(Margins, NoFiniteComparisonIsWrongAboveItsLargestError) {
  const Plan plan = plan_of("published", false);
  std::uint64_t wrong = 0;
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : plan.questions.precisions) {
      const UnitResult done = run_unit(plan, *source, precision, 0, asked);
      const Tally& tally = done.tallies[0];
      for (const auto& [of, comparison] : tally.comparisons) {
        for (const auto& [exponent, count] : comparison.margins.wrong.by_exponent) {
          wrong += count;
          if (exponent == tied_margin || *comparison.range_events != 0) continue;
          const double above = exponent == least_margin_exponent ? 0 : std::ldexp(1.0, exponent);
          EXPECT_LT(above, comparison.largest_error.best().value())
              << source->name() << " " << name(precision) << " " << of;
        }
      }
    }
  }
  EXPECT_GT(wrong, 0u);
}

}  // namespace
}  // namespace axiscert
