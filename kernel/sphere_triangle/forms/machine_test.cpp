// Number types of other machines: the article's own single precision, and the mixed precision of large worlds.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"

namespace axiscert {
namespace {

using arithmetic::Spu;
using testing_support::random_query, testing_support::sides_in;

constexpr float inf = std::numeric_limits<float>::infinity(), max = std::numeric_limits<float>::max();

float sum(float a, float b) { return float(Spu(a) + Spu(b)); }
float product(float a, float b) { return float(Spu(a) * Spu(b)); }

TEST(Spu, ResultsAreChopped) {
  EXPECT_EQ(sum(1, 0x1p-24f), 1);
  EXPECT_EQ(sum(1, 0x1.8p-23f), 1 + 0x1p-23f) << "to nearest it would be 1 + 2^-22";
  EXPECT_EQ(sum(-1, -0x1.8p-23f), -1 - 0x1p-23f) << "toward zero on both sides";
  EXPECT_EQ(sum(1, -0x1p-30f), 1 - 0x1p-24f);
  EXPECT_EQ(sum(1, -0x1p-90f), 1 - 0x1p-24f) << "beyond the digits of a double, too";
  EXPECT_EQ(sum(-1, 0x1p-90f), -1 + 0x1p-24f);
  EXPECT_EQ(sum(1, 0x1p-90f), 1);
  EXPECT_EQ(product(1 + 0x1p-23f, 1.5f), 1.5f + 0x1p-23f);
  EXPECT_EQ(product(1 + 0x1p-23f, -1.5f), -1.5f - 0x1p-23f);
  EXPECT_EQ(float(Spu(1) / Spu(3)), 0x1.555554p-2f);
  EXPECT_EQ(float(Spu(1) / Spu(-3)), -0x1.555554p-2f);
  EXPECT_EQ(float(Spu(1) / Spu(4)), 0.25f);
  EXPECT_EQ(float(square_root(Spu(5))), 0x1.1e3778p1f);
  EXPECT_EQ(float(square_root(Spu(4))), 2);
}

TEST(Spu, ExponentTwoHundredFiftyFiveIsANumber) {
  EXPECT_EQ(product(inf, 0.5f), 0x1p127f);
  EXPECT_EQ(product(std::bit_cast<float>(0x7fc00000u), 0.25f), 0x1.8p126f) << "a NaN's bits: 1.5 2^128";
  EXPECT_GT(Spu(inf), Spu(max));
  EXPECT_GT(Spu(std::bit_cast<float>(0x7fc00000u)), Spu(inf));
  EXPECT_EQ(product(0x1p64f, 0x1p64f), inf) << "2^128 is a number, and has infinity's bits";
  EXPECT_EQ(float((Spu(0x1p64f) * Spu(0x1p64f)) * Spu(0x1p-64f)), 0x1p64f);
}

TEST(Spu, BeyondTheGreatestResultsStayThere) {
  const Spu greatest = Spu(inf) * Spu(2), quarter(0.25f);
  EXPECT_EQ(float(greatest * quarter), 0x1.fffffep126f);
  EXPECT_EQ(float((greatest + greatest) * quarter), 0x1.fffffep126f);
  EXPECT_EQ(float((Spu(-inf) * Spu(inf)) * quarter), -0x1.fffffep126f);
  EXPECT_EQ(float((Spu(3) / Spu(0)) * quarter), 0x1.fffffep126f);
  EXPECT_EQ(float((Spu(-3) / Spu(0)) * quarter), -0x1.fffffep126f);
}

TEST(Spu, NoSubnormalNumbersNoNaNAndNoNegativeZero) {
  EXPECT_EQ(product(0x1p-126f, 0.5f), 0);
  EXPECT_EQ(sum(0x1.8p-126f, -0x1p-126f), 0);
  EXPECT_EQ(product(0x1p-126f, 1), 0x1p-126f) << "the least";
  EXPECT_EQ(sum(0x1p-127f, 0), 0) << "a subnormal operand";
  EXPECT_EQ(sum(inf, -inf), 0);
  EXPECT_EQ(product(0, inf), 0);
  EXPECT_EQ(float(Spu(0) / Spu(0)), 0);
  for (const float zero : {product(-1, 0), product(-0x1p-126f, 0.5f), sum(-0.0f, -0.0f), float(Spu(0) - Spu(0))}) {
    EXPECT_EQ(zero, 0);
    EXPECT_FALSE(std::signbit(zero));
  }
}

// Where no result leaves the range, the article's machine rounds as the processor does toward zero.
TEST(Spu, IsRoundingTowardZeroWithinTheRange) {
  constexpr int seed = 41;
  std::mt19937_64 random(seed);
  for (const char* rung : {"published", "reduced-shared", "ladder-0", "ladder-6"}) {
    const Kernel &on_spu = find_kernel(std::string(rung) + "+spu"), &in_chop = find_kernel(std::string(rung) + "+chop");
    for (int i = 0; i < 2000; ++i) {
      const auto q = random_query<float>(random, false);
      const auto spu = sides_in(on_spu, q);
      const auto chopped = sides_in(in_chop, q);
      ASSERT_EQ(spu.lhs, chopped.lhs) << rung << ", query " << i << " of seed " << seed;
      ASSERT_EQ(spu.rhs, chopped.rhs) << rung << ", query " << i << " of seed " << seed;
    }
  }
}

// The same as binary32 on the query that was translated in binary64 and then rounded.
TEST(WorldDouble, IsBinary32AfterATranslationInBinary64) {
  constexpr int seed = 42;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 2000; ++i) {
    const auto q = random_query<double>(random, false);
    const auto narrow = [](const Vec3<double>& v) { return Vec3<float>{float(v.x), float(v.y), float(v.z)}; };
    const Query<float> local{narrow(q.a - q.p), narrow(q.b - q.p), narrow(q.c - q.p), {0, 0, 0}, float(q.r)};
    const auto wide = sides_in(find_kernel("published+world-double"), q);
    const auto binary32 = sides_in(find_kernel("published"), local);
    for (std::size_t k = 0; k < comparison_count; ++k) {
      ASSERT_EQ(wide.lhs[k], binary32.lhs[k]) << "query " << i << " of seed " << seed << " " << comparisons[k].name;
      ASSERT_EQ(wide.rhs[k], binary32.rhs[k]) << "query " << i << " of seed " << seed << " " << comparisons[k].name;
    }
  }
}

// A kilometre-sized world: a gap of one at 2^40 survives the translation; binary32 coordinates could not represent it.
TEST(WorldDouble, KeepsAGapFarFromTheOrigin) {
  const double far = 0x1p40;
  const Query<double> q{{far + 2, 0, 0}, {far + 2, 1, 0}, {far + 2, 0, 1}, {far, 0, 0}, 1};
  EXPECT_EQ(testing_support::answer(find_kernel("published+world-double"), q).verdict, Verdict::separated);
}

}  // namespace
}  // namespace axiscert
