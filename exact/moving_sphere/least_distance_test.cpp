// The least distance of a motion: by hand, and by two ways that share nothing.
#include "exact/moving_sphere/motion_distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/moving_sphere/moving_sphere_testing.h"

namespace axiscert::moving_sphere {
namespace {

Rational least_squared(const portable::Vec3<double>& p, const portable::Vec3<double>& d) {
  return least_distance(at_the_corner(p, d, 0)).squared;
}

TEST(LeastDistance, IsAsComputedByHand) {
  EXPECT_EQ(least_squared({1, 1, 3}, {0, 0, -2}), 1) << "above the face, at the end";
  EXPECT_EQ(least_squared({1, 1, 1}, {0, 0, 5}), 1) << "above the face, at the start";
  EXPECT_EQ(least_squared({-3, -1, 2}, {6, 0, 0}), 5) << "past the edge AB, at height 2, 1 beside it";
  EXPECT_EQ(least_squared({-3, 0, 2}, {2, 0, 0}), 5) << "stops before the vertex A";
  EXPECT_EQ(least_squared({4, 4, 1}, {0, 0, -2}), 8) << "past the edge BC in the middle: the line x + y = 4";
  EXPECT_EQ(least_squared({4, 4, 1}, {-1, -1, 0}), 3) << "half of the way to it: 2 + 1";
  EXPECT_EQ(least_squared({-2, 1, 0}, {1, -4, 0}), Rational(49, 17)) << "the line through (-2, 1) past the vertex A";
  EXPECT_EQ(least_squared({1, 1, 1}, {0, 0, -2}), 0) << "through the face";
  EXPECT_EQ(least_squared({5, 0, 0}, {0, 0, 0}), 1) << "no motion";
}

TEST(LeastDistance, OfZeroAreaIsThatOfASegmentOrAPoint) {
  MovingQuery<double> q{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {3, -5, 1}, {0, 10, 0}, 0};
  EXPECT_EQ(least_distance(q).squared, 1) << "across the line of three vertices";
  q.p = {-7, 0, 2};
  q.d = {4, 0, 0};
  EXPECT_EQ(least_distance(q).squared, 13) << "along it, ending before it: 3^2 + 2^2";
  q.b = q.c = q.a;
  q.p = {1, 1, 1};
  q.d = {-3, -3, -3};
  EXPECT_EQ(least_distance(q).squared, 0) << "through a point";
  q.d = {0, 0, 0};
  EXPECT_EQ(least_distance(q).squared, 3);
}

TEST(LeastDistance, ACrossingIsStrictlyInsideTheFaceAndTheMotion) {
  const auto crosses = [](const portable::Vec3<double>& p, const portable::Vec3<double>& d) {
    return least_distance(at_the_corner(p, d, 0)).crosses_the_face;
  };
  EXPECT_TRUE(crosses({1, 1, 1}, {0, 0, -2}));
  EXPECT_TRUE(crosses({1, 1, -1}, {0, 0, 2}));
  EXPECT_FALSE(crosses({1, 1, 1}, {0, 0, -1})) << "ends on it";
  EXPECT_FALSE(crosses({1, 1, 0}, {0, 0, -1})) << "begins on it";
  EXPECT_FALSE(crosses({1, 0, 1}, {0, 0, -2})) << "through an edge";
  EXPECT_FALSE(crosses({0, 0, 1}, {0, 0, -2})) << "through a vertex";
  EXPECT_FALSE(crosses({1, 1, 0}, {1, 0, 0})) << "in the plane";
  EXPECT_FALSE(crosses({3, 3, 1}, {0, 0, -2})) << "beside it";
}

// Scaling by a power of two scales the least distance, to the ends of the range and below the least normal.
TEST(LeastDistance, HoldsForEveryExponent) {
  const MovingQuery<double> q = at_the_corner({-2, 1, 0}, {1, -4, 0}, 0);
  for (const int exponent : {-1074, -1000, -1, 0, 1, 500, 1020}) {
    const auto scaled = [&](const portable::Vec3<double>& v) { return v * std::ldexp(1.0, exponent); };
    const MovingQuery<double> image{scaled(q.a), scaled(q.b), scaled(q.c), scaled(q.p), scaled(q.d), 0};
    const Rational unit = exact(std::ldexp(1.0, exponent)), expected = Rational(49, 17) * unit * unit;
    EXPECT_EQ(least_distance(image).squared, expected) << "times 2^" << exponent;
    EXPECT_EQ(swept_squared_distance(image), expected) << "CGAL, times 2^" << exponent;
  }
}

void expect_equal_distances(int queries, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (int i = 0; i < queries; ++i) {
    const MovingQuery<double> q = small_query(random, 1 + i % 4);
    ASSERT_EQ(least_distance(q).squared, swept_squared_distance(q))
        << "seed " << seed << ", query " << i << ": a " << q.a.x << ' ' << q.a.y << ' ' << q.a.z << " b " << q.b.x
        << ' ' << q.b.y << ' ' << q.b.z << " c " << q.c.x << ' ' << q.c.y << ' ' << q.c.z << " p " << q.p.x << ' '
        << q.p.y << ' ' << q.p.z << " d " << q.d.x << ' ' << q.d.y << ' ' << q.d.z;
  }
}
TEST(LeastDistance, IsCgalsOnSmallIntegers) { expect_equal_distances(5000, 20261123); }
TEST(LeastDistanceLong, IsCgalsOnSmallIntegers) { expect_equal_distances(1000000 / TRIAL_DIVISOR, 20261124); }

}  // namespace
}  // namespace axiscert::moving_sphere
