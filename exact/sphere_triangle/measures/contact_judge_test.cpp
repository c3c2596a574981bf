// The judge of a sphere and a triangle, on cases that are worked out by hand.
#include "exact/sphere_triangle/measures/contact_judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace axiscert {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// A triangle that is large, in the plane z = 0, and a sphere of radius 1 whose centre is above its inside.
Query<double> above(double height) { return {{-10, -10, 0}, {10, -10, 0}, {0, 20, 0}, {0, 0, height}, 1}; }
ContactJudgement judged(const Query<double>& q, Verdict said, const std::vector<double>& measures) {
  return SphereTriangleJudge<double>(q).judge(said, measures);
}
ContactJudgement with_normal(const Query<double>& q, const Vec3<double>& n) {
  return judged(q, Verdict::contact, {none, none, n.x, n.y, n.z});
}
double left(const Query<double>& q, const Vec3<double>& n) { return with_normal(q, n).pushed->left.value(); }

TEST(SphereTriangleJudge, WhatAPushLeavesIsAShareOfTheDepth) {
  const Query<double> q = above(0.5);
  EXPECT_EQ(left(q, {0, 0, 1}), 0);
  EXPECT_EQ(left(q, {0, 0, 7}), 0) << "its length says nothing";
  EXPECT_EQ(left(q, {0, 0, -1}), 2);
  EXPECT_EQ(left(q, {1, 0, 0}), 1);
  EXPECT_EQ(left(q, {0, 3, 4}), 0.2) << "exactly, by two roots";
  EXPECT_EQ(left(q, {0, 3, -4}), 1.8);
  EXPECT_EQ(left(q, {0, 0, 0}), 1) << "a push that goes nowhere";
  EXPECT_FALSE(with_normal(above(0), {0, 0, 0}).pushed.has_value()) << "no normal is named there";
  EXPECT_TRUE(with_normal(q, {none, 0, 0}).lacks_push);
  EXPECT_FALSE(with_normal(above(1.5), {none, 0, 0}).lacks_push) << "no depth";
  EXPECT_EQ(with_normal(q, {0, 0, 0}).normal_angle, std::numbers::pi);
  EXPECT_FALSE(with_normal(above(1), {0, 0, 1}).pushed.has_value()) << "no depth";
  EXPECT_FALSE(with_normal(above(1.5), {0, 0, -1}).pushed.has_value());
}

TEST(SphereTriangleJudge, SixDigitsAreRoundedUp) {
  // 0.5 + 0.5 cos is the height, and 1 - cos is left; cos = 1 / sqrt(1 + 2^-20).
  const double x = 0x1p-10, exact_left = 1 - 1 / std::sqrt(1 + x * x);
  const double rounded = left(above(0.5), {x, 0, 1});
  EXPECT_GE(rounded, exact_left);
  EXPECT_LT(rounded, exact_left * (1 + 1.1e-5));
}

TEST(SphereTriangleJudge, AFlipIsToTheOtherSideWhereThereIsOne) {
  EXPECT_TRUE(with_normal(above(0.5), {0, 0, -1}).pushed->is_flip);
  EXPECT_FALSE(with_normal(above(0.5), {1, 0, 0}).pushed->is_flip) << "a right angle is no more than one";
  EXPECT_TRUE(with_normal(above(0.5), {1, 0, -0x1p-20}).pushed->is_flip);
  // On the face both sides are right, and within the rounding of the differences no side is known.
  for (const double height : {0.0, 0x1p-60}) {
    for (const double side : {-1.0, 1.0}) {
      const ContactJudgement found = with_normal(above(height), {0, 0, side});
      EXPECT_FALSE(found.pushed->is_flip) << height;
      EXPECT_LT(found.pushed->left.value(), 1e-17) << height;
    }
  }
  EXPECT_FALSE(with_normal(above(0), {0, 0, 1}).normal_angle.has_value());
  EXPECT_EQ(left(above(0), {1, 0, 0}), 1);
}

TEST(SphereTriangleJudge, SeparationsAreComparedWithARoot) {
  // The nearest point is a vertex, at the distance sqrt(2).
  const Query<double> q = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-1, -1, 0}, 1};
  const double nearest = std::sqrt(2.0) - 1;
  const ContactJudgement found = judged(q, Verdict::separated, {nearest});
  EXPECT_EQ(found.consistency, Consistency::consistent);
  EXPECT_LE(found.separation->ulps.value(), 2) << "half of one of the root, which is more than 1";
  EXPECT_GT(found.separation->ulps.value(), 0);
  const double greatest_distance = std::sqrt(26.0);
  EXPECT_NEAR(judged(q, Verdict::separated, {nearest + 0.5}).separation->share, 0.5 / greatest_distance, 1e-15);
  EXPECT_NEAR(judged(q, Verdict::separated, {-5}).separation->length, nearest + 5, 1e-15);
  EXPECT_EQ(judged(above(3), Verdict::separated, {2}).separation->ulps.value(), 0);
  // The root of 1 + 2^-600 is 1 to more than 240 bits; less 1 it is 2^-601, and 2^-600 is off by 2^52 ulps of that.
  const Query<double> close = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-1, -0x1p-300, 0}, 1};
  EXPECT_NEAR(judged(close, Verdict::separated, {0x1p-600}).separation->ulps.value(), 0x1p52, 0x1p36);
}

TEST(SphereTriangleJudge, AnAnswerMayContradictItself) {
  const auto consistency = [](double height, Verdict said, std::vector<double> measures) {
    return judged(above(height), said, measures).consistency;
  };
  EXPECT_EQ(consistency(0.5, Verdict::contact, {0.1}), Consistency::positive);
  EXPECT_EQ(consistency(0.5, Verdict::contact, {0}), Consistency::consistent);
  EXPECT_EQ(consistency(3, Verdict::separated, {-0.1}), Consistency::negative);
  EXPECT_FALSE(consistency(3, Verdict::separated, {none, none})) << "nothing beside separated";
  EXPECT_EQ(consistency(3, Verdict::separated, {2, none}), Consistency::missing);
  EXPECT_EQ(consistency(0.5, Verdict::contact, {none, 6}), Consistency::missing);
  EXPECT_EQ(consistency(0.5, Verdict::contact, {-INFINITY, 6}), Consistency::missing);
  EXPECT_TRUE(judged(above(0.5), Verdict::contact, {none}).lacks_separation);
  EXPECT_FALSE(judged(above(3), Verdict::separated, {none}).lacks_separation);
}

TEST(SphereTriangleJudge, FeaturesAreThoseThatAreNearest) {
  // Over the edge ab, seen along it: the edge alone is nearest.
  const Query<double> q = {{-1, 0, 0}, {1, 0, 0}, {0, 5, 0}, {0, -1, 1}, 2};
  const auto feature = [&](double number) { return judged(q, Verdict::contact, {none, number}); };
  EXPECT_EQ(feature(3).feature_is_right, true);
  for (const double wrong : {0.0, 1.0, 2.0, 4.0, 5.0, 6.0, 7.0, -1.0, 2.5})
    EXPECT_EQ(feature(wrong).feature_is_right, false);
  EXPECT_TRUE(std::isinf(*feature(7).feature_error));
  EXPECT_GT(*feature(6).feature_error, 0);
  // Two equal vertices: either name is right.
  const Query<double> repeated = {{0, 0, 0}, {0, 0, 0}, {0, 5, 0}, {0, -1, 0}, 2};
  for (const double right : {0.0, 1.0})
    EXPECT_EQ(judged(repeated, Verdict::contact, {none, right}).feature_is_right, true);
}

TEST(SphereTriangleJudge, ThePlaceIsShownInDoubles) {
  const ContactPlace place = SphereTriangleJudge<float>(above(0.5)).place();
  EXPECT_EQ(place.separation, -0.5);
  EXPECT_EQ(place.point, (std::array<double, 3>{0, 0, 0}));
  EXPECT_EQ(place.from_a, (std::array<double, 3>{10, 10, 0}));
  EXPECT_EQ(place.normal, (std::array<double, 3>{0, 0, 1}));
  EXPECT_FALSE(SphereTriangleJudge<float>(above(0)).place().normal.has_value());
}

}  // namespace
}  // namespace axiscert
