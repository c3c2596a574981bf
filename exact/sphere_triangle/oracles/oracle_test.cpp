// The oracles compared with each other and with computations by hand; the exhaustive lattice; a fault that must be
// detected.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {

namespace {

int by_value(const BinaryNumber& a, const BinaryNumber& b) { return order(a, b); }

template <class Real>
class OracleTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(OracleTest, Reals);

TYPED_TEST(OracleTest, HandComputedDistances) {
  using Q = Query<TypeParam>;
  const Vec3<TypeParam> a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
  EXPECT_EQ(squared_distance(Q{a, b, c, {TypeParam(0.25), TypeParam(0.25), 3}, 0}), 9);
  EXPECT_EQ(squared_distance(Q{a, b, c, {1, 1, 0}, 0}), Rational(1, 2));
  EXPECT_EQ(squared_distance(Q{a, b, c, {-3, -4, 12}, 0}), 169);
  EXPECT_EQ(squared_distance(Q{a, a, a, {2, 0, 0}, 0}), 4) << "a triangle that is a point";
  EXPECT_EQ(squared_distance(Q{a, b, b, {2, 1, 0}, 0}), 2) << "a triangle that is a segment";
  EXPECT_EQ(distance_order(Q{a, b, c, {0, 0, 2}, 2}), 0);
  EXPECT_EQ(distance_order(Q{a, b, c, {0, 0, 2}, std::nextafter(TypeParam(2), TypeParam(3))}), -1);
  EXPECT_EQ(distance_order(Q{a, b, c, {0, 0, 2}, std::nextafter(TypeParam(2), TypeParam(1))}), 1);
}

// The closed sphere is solid: a triangle wholly inside it is in contact with it.
TYPED_TEST(OracleTest, ATriangleInsideTheSphereIsContact) {
  const Query<TypeParam> q{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 100};
  EXPECT_EQ(exact_truth(q, true).verdict, Verdict::contact);
}

TYPED_TEST(OracleTest, BadInputIsInvalidAndMinusZeroIsARadius) {
  constexpr TypeParam inf = std::numeric_limits<TypeParam>::infinity();
  Query<TypeParam> q{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, TypeParam(-0.0)};
  EXPECT_EQ(exact_truth(q, true).verdict, Verdict::separated);
  q.r = -std::numeric_limits<TypeParam>::denorm_min();
  EXPECT_EQ(exact_truth(q, true).verdict, Verdict::invalid);
  q.r = 0;
  q.b.y = inf;
  EXPECT_EQ(exact_truth(q, true).verdict, Verdict::invalid);
  q.b.y = std::numeric_limits<TypeParam>::quiet_NaN();
  EXPECT_EQ(exact_truth(q, true).verdict, Verdict::invalid);
}

// All oracles together: CGAL, the ring and MPFR agree (exact_truth throws if they do not) on the least and greatest
// numbers there are.
TYPED_TEST(OracleTest, OraclesAgreeAtTheEndsOfTheRange) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam ends[] = {
      0, Limits::denorm_min(), Limits::min(), 1, Limits::max(), -Limits::max(), -Limits::denorm_min()};
  std::mt19937_64 random(3);
  for (int i = 0; i < 300; ++i) {
    std::array<TypeParam, coordinate_count> v;
    for (TypeParam& x : v) x = ends[random() % std::size(ends)];
    v[12] = std::abs(v[12]);
    EXPECT_NO_THROW(exact_truth(from_coordinates(v), true)) << "case " << i;
  }
}

TYPED_TEST(OracleTest, OraclesAgreeOnArbitraryBits) {
  std::mt19937_64 random(5);
  const int count = sizeof(TypeParam) == 4 ? 1000 : 150;
  for (int i = 0; i < count; ++i) {
    std::array<TypeParam, coordinate_count> v;
    for (TypeParam& x : v) {
      using Bits = std::conditional_t<sizeof(TypeParam) == 4, std::uint32_t, std::uint64_t>;
      do x = std::bit_cast<TypeParam>(static_cast<Bits>(random()));
      while (!std::isfinite(x));
    }
    v[12] = std::abs(v[12]);
    EXPECT_NO_THROW(exact_truth(from_coordinates(v), true)) << "case " << i << " of seed 5";
  }
}

// The counts over all triangles with vertices in {-n..n}^3, with the centre at the origin.
struct LatticeCount {
  std::uint64_t triangles = 0, zero_area = 0, strict_wrong = 0, nonstrict_wrong = 0, missed_contacts = 0;
  std::uint64_t oracle_differences = 0;
};

// Radii below, at and above the distance: with the squared distance D = num/den, everything is scaled by den so that D
// den^2 is an integer, and r^2 is that integer or off it by one part in 2^40. No two boundaries of the lattice are that
// close to each other (they are quotients of integers below 2^16).
LatticeCount judge_lattice(int n) {
  LatticeCount count;
  const int side = 2 * n + 1, points = side * side * side;
  const auto vertex = [&](int i) {
    return Vec3<double>{double(i % side - n), double(i / side % side - n), double(i / side / side - n)};
  };
  for (int i = 0; i < points; ++i)
    for (int j = 0; j < points; ++j)
      for (int k = 0; k < points; ++k) {
        const Query<double> q{vertex(i), vertex(j), vertex(k), {0, 0, 0}, 0};
        ++count.triangles;
        const auto normal = portable::cross(q.b - q.a, q.c - q.a);
        const bool zero_area = portable::dot(normal, normal) == 0;
        count.zero_area += zero_area;
        const Rational distance2 = squared_distance(q);
        const double den = distance2.get_den().get_d(), scaled = distance2.get_num().get_d() * den;
        const auto scale = [&](const Vec3<double>& v) {
          return Vec3<BinaryNumber>{BinaryNumber(v.x * den), BinaryNumber(v.y * den), BinaryNumber(v.z * den)};
        };
        bool strict_wrong = false;
        for (const int offset : {-1, 0, 1}) {
          if (scaled == 0 && offset < 0) continue;  // no radius is below zero
          const BinaryNumber rr =
              BinaryNumber(scaled) +
              (scaled == 0 ? BinaryNumber(offset) : BinaryNumber(scaled * offset) * BinaryNumber(0x1p-40));
          const portable::CentredProblem<BinaryNumber> centred{scale(q.a), scale(q.b), scale(q.c), rr};
          const ExactSides truth = exact_sides(centred);
          const bool separated = offset < 0;
          const bool strict = axes_of(truth.strict) != 0, nonstrict = axes_of(truth.holding(side_comparisons)) != 0;
          strict_wrong |= strict != separated;
          count.missed_contacts += strict && !separated;
          count.nonstrict_wrong += nonstrict != separated;
          const auto walked = walked_squared_distance(centred, BinaryNumber(), BinaryNumber(1), by_value);
          count.oracle_differences += by_value(walked.numerator, rr * walked.denominator) != -offset;
        }
        if (strict_wrong) {
          ++count.strict_wrong;
          EXPECT_TRUE(zero_area) << "the strict test is wrong on a triangle with area: " << i << " " << j << " " << k;
        }
      }
  return count;
}

TEST(Lattice, ExhaustiveOverMinusOneToOne) {
  const LatticeCount count = judge_lattice(1);
  EXPECT_EQ(count.triangles, 19683u);
  EXPECT_EQ(count.zero_area, 2427u);
  EXPECT_EQ(count.strict_wrong, 2114u);
  EXPECT_EQ(count.nonstrict_wrong, 0u);
  EXPECT_EQ(count.missed_contacts, 0u) << "the strict test's fault is a phantom contact, always";
  EXPECT_EQ(count.oracle_differences, 0u);
}

// Slow builds have the triangles of -1 to 1 alone, a hundredth of these, through the same code.
#if TRIAL_DIVISOR == 1
TEST(LatticeLong, ExhaustiveOverMinusTwoToTwo) {
  const LatticeCount count = judge_lattice(2);
  EXPECT_EQ(count.triangles, 1953125u);
  EXPECT_EQ(count.zero_area, 57773u);
  EXPECT_EQ(count.strict_wrong, 53626u);
  EXPECT_EQ(count.nonstrict_wrong, 0u);
  EXPECT_EQ(count.missed_contacts, 0u);
  EXPECT_EQ(count.oracle_differences, 0u);
}
#endif

}  // namespace
}  // namespace axiscert
