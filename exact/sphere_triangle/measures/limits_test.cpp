// Queries exactly on a limit, and one float to each side of it.
#include "exact/sphere_triangle/measures/limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/trait/critical_radius.h"
#include "exact/trait/oracles.h"

namespace axiscert {
namespace {

const Query<float> half_a_square{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 1};  // area 1/2

TEST(Limits, NoneHoldEverything) {
  EXPECT_FALSE(Limits{}.any());
  EXPECT_TRUE(is_within({}, half_a_square));
  EXPECT_TRUE(is_within({}, Query<float>{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}, 0}));
}

TEST(Limits, ArePartOfWhatAKernelPromises) {
  Kernel kernel = find_kernel("published");
  const Numbers<float> q(half_a_square);
  EXPECT_TRUE(is_promised(kernel, q));
  kernel.limits.least_radius = 2;
  EXPECT_FALSE(is_promised(kernel, q));
  kernel.limits.least_radius = 1;
  EXPECT_TRUE(is_promised(kernel, q));
}

TEST(Limits, BoundsAreWithin) {
  EXPECT_TRUE(is_within({.least_coordinate = 1, .greatest_coordinate = 2}, half_a_square));
  EXPECT_FALSE(is_within({.least_coordinate = std::nextafter(1.0, 2)}, half_a_square));
  EXPECT_FALSE(is_within({.greatest_coordinate = std::nextafter(2.0, 1)}, half_a_square));
  EXPECT_TRUE(is_within({.least_radius = 1, .greatest_radius = 1}, half_a_square));
  EXPECT_FALSE(is_within({.least_radius = std::nextafter(1.0, 2)}, half_a_square));
  EXPECT_FALSE(is_within({.greatest_radius = std::nextafter(1.0, 0)}, half_a_square));
}

TEST(Limits, ZeroIsNoCoordinateTooSmallAndTheSignIsNothing) {
  const Query<double> q{{-3, 0, -0.0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 1};
  EXPECT_TRUE(is_within({.least_coordinate = 1, .greatest_coordinate = 3}, q));
  EXPECT_FALSE(is_within({.greatest_coordinate = 2}, q));
  Query<double> small = q;
  small.p.z = -0x1p-1074;
  EXPECT_FALSE(is_within({.least_coordinate = 1}, small)) << "the centre counts";
  EXPECT_TRUE(is_within({.greatest_radius = 1}, Query<double>{q.a, q.b, q.c, q.p, -0.0}));
}

TEST(Limits, AreaIsExact) {
  EXPECT_TRUE(is_within({.least_area = 0.5}, half_a_square));
  EXPECT_FALSE(is_within({.least_area = std::nextafter(0.5, 1)}, half_a_square));
  const Query<float> root{{0, 0, 0}, {2, 0, 0}, {0, 1, 1}, {5, 5, 5}, 1};  // area sqrt(2)
  const double nearest = std::sqrt(2.0);                                   // above the root
  EXPECT_FALSE(is_within({.least_area = nearest}, root));
  EXPECT_TRUE(is_within({.least_area = std::nextafter(nearest, 1)}, root));
}

// Areas whose square is outside binary64's range, and whose value computed in floats would be 0 or infinity.
TEST(Limits, AreaHasNoRange) {
  const float tiny = 0x1p-149f, huge = 0x1p127f;
  const Query<float> small{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, 0}, 1};
  EXPECT_TRUE(is_within({.least_area = 0x1p-299}, small));
  EXPECT_FALSE(is_within({.least_area = std::nextafter(0x1p-299, 1)}, small));
  const Query<double> large{{0, 0, 0}, {huge, 0, 0}, {0, 0x1p1000, 0}, {0, 0, 0}, 1};
  EXPECT_TRUE(is_within({.least_area = 0x1p1023}, large));
  const Query<double> line{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {0, 0, 0}, 1};
  EXPECT_FALSE(is_within({.least_area = 0x1p-1074}, line));
}

TEST(Limits, RadiiAreRoundedInward) {
  EXPECT_EQ(radii_within<float>({}), RadiusRange<float>());
  const auto tenth = radii_within<float>({.least_radius = 0.1, .greatest_radius = 0.1 + 0x1p-20});
  EXPECT_GE(tenth.least, 0.1);
  EXPECT_LT(std::nextafter(tenth.least, 0.f), 0.1);
  EXPECT_LE(tenth.greatest, 0.1 + 0x1p-20);
  EXPECT_GT(std::nextafter(tenth.greatest, 1.f), 0.1 + 0x1p-20);
  EXPECT_EQ(radii_within<float>({.greatest_radius = 1e300}), RadiusRange<float>());
  EXPECT_EQ(radii_within<double>({.least_radius = 0.1}).least, 0.1);
  const auto none = radii_within<float>({.least_radius = 0.1, .greatest_radius = 0.1});
  EXPECT_GT(none.least, none.greatest) << "no float is 0.1";
  EXPECT_GT(radii_within<float>({.least_radius = 1e300}).least, std::numeric_limits<float>::max());
}

}  // namespace
}  // namespace axiscert
