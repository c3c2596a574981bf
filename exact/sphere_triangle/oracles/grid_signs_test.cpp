// Signs by integers compared with those of arbitrary precision: on every query of small lattices, at the limits of
// every width, and for numbers however far apart.
#include "exact/sphere_triangle/oracles/grid_signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <random>

#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {
namespace {

template <class Real>
Signs expected(const Query<Real>& q) {
  return signs_of(exact_sides(q));
}

template <class Real>
testing::AssertionResult agrees(const Query<Real>& q) {
  if (integer_signs(q) == expected(q)) return testing::AssertionSuccess();
  auto failure = testing::AssertionFailure() << std::hexfloat << "other signs:";
  for (const Real x : coordinates(q)) failure << ' ' << x;
  return failure;
}

template <class Real>
class GridSigns : public testing::Test {};
using Reals = testing::Types<float, double>;
template <class Real>
using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
TYPED_TEST_SUITE(GridSigns, Reals);

// All triangles on the 27 points of {-1, 0, 1}^3, around (0, 0, 0) and (1, 0, 0), at radii of halves: repeated
// vertices, zero areas, and ties in every comparison among them.
TYPED_TEST(GridSigns, AreExactOnEveryTriangleOfASmallLattice) {
  SignBits tied = 0, held = 0, failed = 0;
  for (int triangle = 0; triangle < 19683; ++triangle) {
    std::array<TypeParam, coordinate_count> x{};
    for (int i = 0, rest = triangle; i < 9; ++i, rest /= 3) x[static_cast<std::size_t>(i)] = TypeParam(rest % 3 - 1);
    for (int halves = 0; halves < 4; ++halves) {
      x[9] = TypeParam(halves % 2);
      x[12] = TypeParam(halves) / 2;
      const auto q = from_coordinates(x);
      ASSERT_TRUE(agrees(q));
      const Signs signs = integer_signs(q);
      tied |= signs.ties;
      held |= signs.strict;
      failed |= static_cast<SignBits>(~(signs.ties | signs.strict));
    }
  }
  EXPECT_EQ(tied, 0xffff);
  EXPECT_EQ(held, 0xffff);
  EXPECT_EQ(failed, 0xffff);
}

// The greatest magnitudes of each width together with a 1, so that no power of two can be divided out; and one bit
// more.
TYPED_TEST(GridSigns, AreExactAtTheLimitOfEveryWidth) {
  constexpr int seed = 81, digits = std::numeric_limits<TypeParam>::digits;
  std::mt19937_64 random(seed);
  for (int words = 1; words <= most_grid_words; ++words) {
    for (const int bits : {grid_bits(words) - 1, grid_bits(words), grid_bits(words) + 1}) {
      const auto two_to_bits = std::ldexp(TypeParam(1), bits);
      const auto greatest = two_to_bits - std::max(TypeParam(1), std::ldexp(TypeParam(1), bits - digits));
      for (int i = 0; i < 4000; ++i) {
        std::array<TypeParam, coordinate_count> x{};
        for (const std::size_t k : {0, 1, 2, 3, 4, 5, 6, 7, 8, 12}) {
          const TypeParam sizes[] = {0, 1, std::floor(greatest / 2), greatest, greatest, greatest, greatest, greatest};
          const std::uint64_t choice = random();
          x[k] = choice % 16 >= 8 && k != 12 ? -sizes[choice % 8] : sizes[choice % 8];
        }
        x[random() % 3] = greatest;
        x[4] = 1;
        x[9] = TypeParam(i % 2);
        const auto q = from_coordinates(x);
        // With the centre at 1 the differences have the same number of bits or one more.
        const int found_bits = bits_on_grid(q).value();
        ASSERT_TRUE(found_bits == bits || found_bits == bits + 1) << bits << " bits, seed " << seed;
        ASSERT_TRUE(agrees(q)) << "seed " << seed;
      }
    }
  }
}

// Lattices of every size and at every scale of the precision; radii equal to the distance of a vertex or an edge if
// that is a number of the precision.
TYPED_TEST(GridSigns, AreExactAtEverySizeAndScale) {
  constexpr int seed = 82, digits = std::numeric_limits<TypeParam>::digits;
  using Limits = std::numeric_limits<TypeParam>;
  std::mt19937_64 random(seed);
  std::map<int, int> by_words;
  for (int i = 0; i < 60000; ++i) {
    const int spread = static_cast<int>(random() % 160), size = 1 + static_cast<int>(random() % digits);
    const int least = Limits::min_exponent - digits, most = Limits::max_exponent - spread - digits;
    const int scale = least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
    std::array<TypeParam, coordinate_count> x{};
    for (TypeParam& v : x) {
      const auto integer = static_cast<TypeParam>(static_cast<std::int64_t>(random()) >> (64 - size));
      v = std::ldexp(integer, scale + static_cast<int>(random() % static_cast<unsigned>(spread + 1)));
    }
    x[12] = std::abs(i % 4 == 0 ? x[0] : x[12]);
    if (i % 4 == 0) x[1] = x[10], x[2] = x[11], x[9] = 0;
    if (i % 8 == 0) x[3] = x[0], x[4] = x[10];
    const auto q = from_coordinates(x);
    const std::optional<int> bits = bits_on_grid(q);
    ASSERT_TRUE(agrees(q)) << "query " << i << " of seed " << seed;
    int words = 1;
    while (words <= most_grid_words && !(bits && *bits <= grid_bits(words))) ++words;
    ++by_words[words];
  }
  for (int words = 1; words <= most_grid_words + 1; ++words) EXPECT_GT(by_words[words], 1000) << words;
}

// 2^126 is the widest range of numbers that fits a few words; zeros, of either sign, do not count.
TYPED_TEST(GridSigns, AreExactWhereTheNumbersAreJustTooFarApart) {
  const auto wide = [](int exponent) {
    const auto x = std::ldexp(TypeParam(1), -exponent), zero = TypeParam(0);
    return Query<TypeParam>{{1, 0, 0}, {x, 1, -zero}, {0, 0, 1}, {zero, -zero, zero}, zero};
  };
  for (const int exponent : {greatest_grid_bits - 1, greatest_grid_bits, 125, 126, 127, 149}) {
    EXPECT_TRUE(agrees(wide(exponent))) << exponent;
  }
  EXPECT_EQ(bits_on_grid(wide(125)), 126);
  EXPECT_EQ(bits_on_grid(wide(126)), std::nullopt);
  EXPECT_EQ(bits_on_grid(Query<TypeParam>{}), 0);
  EXPECT_TRUE(agrees(Query<TypeParam>{}));
}

// The least and the greatest numbers of the precision, with ones and zeros: every number, every difference and every
// degree at its greatest size. Repeated vertices and ties occur.
TYPED_TEST(GridSigns, AreExactAtBothEndsOfThePrecision) {
  constexpr int seed = 83;
  using Limits = std::numeric_limits<TypeParam>;
  std::mt19937_64 random(seed);
  const TypeParam sizes[] = {0, Limits::denorm_min(), Limits::min(), 1, Limits::max(), Limits::max()};
  for (int i = 0; i < 5000; ++i) {
    std::array<TypeParam, coordinate_count> x{};
    for (TypeParam& v : x) v = sizes[random() % 6] * (random() % 2 == 0 ? TypeParam(1) : TypeParam(-1));
    x[12] = std::abs(x[12]);
    if (i % 4 == 0) std::copy_n(x.begin(), 3, x.begin() + 3 + static_cast<int>(random() % 3) * 3);
    ASSERT_TRUE(agrees(from_coordinates(x))) << "query " << i << " of seed " << seed;
  }
  const TypeParam most = Limits::max(), least = Limits::denorm_min();
  EXPECT_TRUE(agrees(
      Query<TypeParam>{{most, most, most}, {most, -most, least}, {-most, least, most}, {-most, -most, -most}, most}));
}

// The least radius with coordinates of any size, on lattices with ties in every comparison; and other small radii.
TYPED_TEST(GridSigns, AreExactAtTinyRadii) {
  constexpr int seed = 85;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i) {
    std::array<TypeParam, coordinate_count> x{};
    const int size = 1 + static_cast<int>(random() % (i % 2 == 0 ? 2 : 20));
    for (TypeParam& v : x) v = static_cast<TypeParam>(static_cast<std::int64_t>(random()) >> (64 - size));
    const int least = std::numeric_limits<TypeParam>::min_exponent - std::numeric_limits<TypeParam>::digits;
    x[12] = std::ldexp(TypeParam(1), i % 4 < 2 ? least : -static_cast<int>(random() % 149));
    ASSERT_TRUE(agrees(from_coordinates(x))) << "query " << i << " of seed " << seed;
  }
}

// A radius below the unit of the other numbers that is not tiny: the line through (2^k, 1, 0) and (-3 2^k, -2, 0)
// passes at 1/4 from the centre; the same in another plane, and in a triangle that is large in both directions.
TYPED_TEST(GridSigns, AreExactAtRadiiBelowTheUnitThatAreNotTiny) {
  for (int k = 60; k <= 120; ++k) {
    const TypeParam far = std::ldexp(TypeParam(1), k), quarter = TypeParam(0.25);
    const TypeParam above = std::nextafter(quarter, TypeParam(1)), below = std::nextafter(quarter, TypeParam(0));
    for (const TypeParam r : {above, below, above / 4, above * 2, below * 2, std::ldexp(above, -k)}) {
      ASSERT_TRUE(agrees(Query<TypeParam>{{far, 1, 0}, {-3 * far, -2, 0}, {0, 5, 7}, {}, r})) << k << ' ' << r;
      ASSERT_TRUE(agrees(Query<TypeParam>{{0, 5, 7}, {far, 0, 1}, {-3 * far, 0, -2}, {}, r})) << k << ' ' << r;
      ASSERT_TRUE(agrees(Query<TypeParam>{{far, 0, 1}, {-3 * far, far, -2}, {far, -3 * far, 1}, {}, r}))
          << k << ' ' << r;
    }
  }
}

// Arbitrary bit patterns of finite numbers.
TYPED_TEST(GridSigns, AreExactOnRandomBits) {
  constexpr int seed = 84;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 3000;) {
    std::array<TypeParam, coordinate_count> x{};
    for (TypeParam& v : x) v = std::bit_cast<TypeParam>(static_cast<Bits<TypeParam>>(random()));
    x[12] = std::abs(x[12]);
    if (!std::all_of(x.begin(), x.end(), [](TypeParam v) { return std::isfinite(v); })) continue;
    ASSERT_TRUE(agrees(from_coordinates(x))) << "query " << i << " of seed " << seed;
    ++i;
  }
}

}  // namespace
}  // namespace axiscert
