// R-infinity compared with the reference: identical, for every rung in every arithmetic, if no range flag is raised.
#include "exact/sphere_triangle/unbounded.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <random>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
namespace {

// Queries whose bits depend on roundings: slivers and repeated vertices, far from the centre or not, with the radius
// nearest to the distance.
template <class Real>
Query<Real> close_to_a_tie(std::mt19937_64& random, int kind) {
  const auto unit = [&] { return static_cast<Real>(static_cast<std::int64_t>(random()) >> 11) * Real(0x1p-52); };
  const auto vec = [&] { return Vec3<Real>{unit(), unit(), unit()}; };
  Query<Real> q{vec(), vec(), vec(), vec() * (kind % 2 == 0 ? Real(1) : Real(0x1p-7)), 0};
  if (kind % 4 == 1) q.b = q.a;
  if (kind % 4 == 2) q.c = q.a + (q.b - q.a) * unit();
  q.r = nearest_sqrt<Real>(squared_distance(q));
  return q;
}

// An arithmetic whose flags are reliable and that gives the same results within the range.
Arithmetic with_flags(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::ftz:
      return Arithmetic::plain;
    case Arithmetic::spu:
      return Arithmetic::chop;
    default:
      return arithmetic;
  }
}

template <class Real>
void expect_no_difference() {
  constexpr int seed = 71, queries = 96;
  for (const ArithmeticInfo& info : arithmetics()) {
    if (!(sizeof(Real) == 4 ? info.in_binary32 : info.in_binary64)) continue;
    std::mt19937_64 random(seed);
    int compared = 0, unlike_plain = 0;
    for (int i = 0; i < queries; ++i) {
      const auto q = close_to_a_tie<Real>(random, i);
      const Strictness strictness = i % 3 == 0 ? Strictness::nonstrict : Strictness::strict;
      for (std::size_t f = 0; f < formulae_count; ++f) {
        const auto formulae = static_cast<Formulae>(f);
        if (kind_of(formulae) != FormulaeKind::rung && info.arithmetic != Arithmetic::plain) continue;
        std::feclearexcept(FE_ALL_EXCEPT);
        reference(formulae, with_flags(info.arithmetic), strictness, q);
        // The article's machine has no NaN.
        const int no_numbers = info.arithmetic == Arithmetic::spu ? FE_INVALID | FE_DIVBYZERO : 0;
        if (std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW | no_numbers) != 0) continue;
        const Outcome found = unbounded(formulae, info.arithmetic, strictness, q);
        const Outcome expected = reference(formulae, info.arithmetic, strictness, q);
        ASSERT_EQ(found.verdict, expected.verdict)
            << name(formulae) << "+" << info.name << ", query " << i << " of seed " << seed;
        ASSERT_EQ(found.bits, expected.bits)
            << name(formulae) << "+" << info.name << ", query " << i << " of seed " << seed;
        ++compared;
        unlike_plain += found != unbounded(formulae, Arithmetic::plain, strictness, q);
      }
    }
    EXPECT_GT(compared, queries * 10) << info.name;
    // Otherwise these queries would not distinguish the arithmetic from `plain`. The early rungs of `prescaled` are
    // centred, those of `plain` are not.
    const bool rounds_as_plain = info.arithmetic == Arithmetic::plain || info.arithmetic == Arithmetic::ftz;
    if (rounds_as_plain) {
      EXPECT_EQ(unlike_plain, 0) << info.name;
    } else {
      EXPECT_GT(unlike_plain, 0) << info.name;
    }
  }
}

TEST(Unbounded, IsTheReferenceWithinTheRangeInBinary32) { expect_no_difference<float>(); }
TEST(Unbounded, IsTheReferenceWithinTheRangeInBinary64) { expect_no_difference<double>(); }

// Beyond the range the two differ, and only the verdict of R-infinity is that of the unscaled query.
TEST(Unbounded, DoesNotKnowTheScale) {
  const Query<float> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, 1};
  for (const float s : {0x1p40f, 0x1p-40f}) {
    const Query<float> scaled{q.a * s, q.b * s, q.c * s, q.p * s, q.r * s};
    for (const ArithmeticInfo& info : arithmetics()) {
      if (!info.in_binary32) continue;
      const RoundedDecisions found = rounded(Formulae::published, info.arithmetic, Strictness::strict, scaled);
      EXPECT_EQ(found.range_free.verdict, Verdict::separated) << info.name << " at " << s;
      const bool keeps = info.arithmetic == Arithmetic::prescaled || info.arithmetic == Arithmetic::in_double;
      // When rounding toward +infinity, a vanishing side stays above 0; when rounding toward zero, an overflowing side
      // stays below infinity.
      if (info.arithmetic == Arithmetic::plain || keeps) {
        EXPECT_EQ(found.reference.verdict, keeps ? Verdict::separated : Verdict::contact) << info.name << " at " << s;
      }
    }
  }
}

}  // namespace
}  // namespace axiscert
