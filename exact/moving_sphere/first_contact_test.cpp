// The first time of contact: by hand, and by verdicts about parts of the motion, which CGAL gives.
#include "exact/moving_sphere/first_contact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/judge/depth.h"
#include "exact/moving_sphere/motion_distance.h"
#include "exact/moving_sphere/moving_sphere_testing.h"

namespace axiscert::moving_sphere {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;
using enum Feature;

FirstContact contact_of(const portable::Vec3<double>& p, const portable::Vec3<double>& d, double r) {
  return first_contact(at_the_corner(p, d, r)).value();
}

Start start_of(const MovingQuery<double>& q) {
  const std::optional<FirstContact> found = first_contact(q);
  return found ? found->start : Start::clear;
}

void expect_contact(const FirstContact& found, const Rational& time, const FeatureSet& features,
                    const std::string& says) {
  EXPECT_EQ(compare(found.time, time), 0) << says;
  EXPECT_EQ(found.features.bits(), features.bits()) << says;
}

TEST(FirstContact, IsAsComputedByHand) {
  expect_contact(contact_of({1, 1, 3}, {0, 0, -4}, 1), Rational(1, 2), {face}, "down on the face");
  expect_contact(contact_of({1, 1, -3}, {0, 0, 2}, 1), 1, {face}, "from below, at the end");
  expect_contact(contact_of({2, -3, 0}, {0, 4, 0}, 1), Rational(1, 2), {edge_ab}, "in the plane against AB");
  expect_contact(contact_of({-6, 0, 0}, {8, 0, 0}, 2), Rational(1, 2), {vertex_a, edge_ca},
                 "along the line of AB: A is nearest, which is also the foot on CA");
  expect_contact(contact_of({0, 0, 5}, {0, 0, -4}, 1), 1, {vertex_a, edge_ab, edge_ca, face},
                 "straight down on A, where four features meet");
  expect_contact(contact_of({1, 1, 0.5}, {3, 5, 7}, 1), 0, {face}, "begins in contact");
  expect_contact(contact_of({1, 1, 1}, {0, 0, 0}, 1), 0, {face}, "stands and touches");
  EXPECT_FALSE(first_contact(at_the_corner({1, 1, 3}, {0, 0, -1}, 1))) << "stops above it";
  EXPECT_FALSE(first_contact(at_the_corner({1, 1, 3}, {0, 0, 9}, 1))) << "moves away";
}

// |(4 t - 2, -1)| = 2 at t = 1/2 - sqrt(3)/4 = 0.066987298107780676618...
TEST(FirstContact, AnIrrationalTimeIsKeptAsItIs) {
  const FirstContact found = contact_of({-2, -1, 0}, {4, 0, 0}, 2);
  EXPECT_EQ(found.time.rest, Rational(1, 2));
  EXPECT_EQ(found.time.square, Rational(3, 16));
  EXPECT_EQ(found.features.bits(), FeatureSet{vertex_a}.bits());
  EXPECT_EQ(rounded_down<double>(found.time), 0x1.126145e9ecd56p-4);
  EXPECT_EQ(rounded_down<float>(found.time), 0x1.126144p-4f) << "nearest would be 0x1.126146p-4, which is late";
}

TEST(FirstContact, OfZeroAreaIsThatOfASegmentOrAPoint) {
  MovingQuery<double> q{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {3, -5, 0}, {0, 8, 0}, 1};
  expect_contact(first_contact(q).value(), Rational(1, 2), {edge_bc, edge_ca}, "across the line of three vertices");
  q = {{2, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 0, 0}, {4, 0, 0}, 0};
  expect_contact(first_contact(q).value(), Rational(1, 2), {vertex_a, vertex_b, vertex_c}, "a point through a point");
}

TEST(FirstContact, TheStartIsToldApart) {
  EXPECT_EQ(start_of(at_the_corner({1, 1, 0.5}, {0, 0, 9}, 1)), Start::overlap);
  EXPECT_EQ(start_of(at_the_corner({1, 1, 1}, {0, 0, 9}, 1)), Start::touching);
  EXPECT_EQ(start_of(at_the_corner({1, 1, 2}, {0, 0, -9}, 1)), Start::clear);
}

// From z = 2^60 down to z = 1 on the face: D = 1 - 2^60 is no double.
TEST(FirstContact, OfAMotionByItsEndsHasTheExactDisplacement) {
  EndsQuery<double> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0x1p60}, {1, 1, 1}, 2};
  const Rational far = exact(0x1p60);
  expect_contact(first_contact(q).value(), Rational((far - 2) / (far - 1)), {face}, "a unit before the end");
  EXPECT_EQ(swept_distance_order(q), -1);
  q.r = 1;
  expect_contact(first_contact(q).value(), 1, {face}, "touches at the end");
  EXPECT_EQ(swept_distance_order(q), 0);
  EXPECT_EQ(swept_distance_order(q, 0.5), 1);
  q.r = 0.5;
  EXPECT_FALSE(first_contact(q));
  EXPECT_EQ(least_distance(q).squared, 1);
}

TEST(RootTime, SignsAreThoseOfTheNumber) {
  const RootTime t{2, 2};  // 2 - sqrt 2 = 0.5857...
  EXPECT_EQ(compare(t, Rational(585, 1000)), 1);
  EXPECT_EQ(compare(t, Rational(586, 1000)), -1);
  EXPECT_EQ(sign_at(t, 0, -1), -1);
  EXPECT_EQ(sign_at(t, Rational(586, 1000), -1), 1);
  EXPECT_EQ(sign_at(t, -3, 0), -1);
  EXPECT_EQ(compare({Rational(1, 4), 0}, Rational(1, 4)), 0);
  EXPECT_EQ(compare({3, 4}, 1), 0);
}

TEST(RootTime, AnErrorIsRoundedOnceToTheNearest) {
  const auto rounded = [](const RootTime& t, const Rational& s, const Rational& squared = 1) {
    return rounded_apart(t, s, apart(t, s), squared);
  };
  const auto of = [&](const Rational& t, const Rational& squared = 1) { return rounded({t, 0}, 0, squared); };
  const Rational half_ulp = exact(0x1p-53), tiny = exact(0x1p-600);
  EXPECT_EQ(of(1 + half_ulp), 1) << "a tie goes to the even one";
  EXPECT_EQ(of(1 + 3 * half_ulp), 1 + 0x1p-51);
  EXPECT_EQ(of(1 + half_ulp + tiny), 1 + 0x1p-52);
  EXPECT_EQ(of(1 + half_ulp - tiny), 1);
  EXPECT_EQ(of(1 + half_ulp, exact(0x1p60)), 0x1p30) << "the same tie in another unit";
  EXPECT_EQ(of(1, 2), std::sqrt(2.0));
  EXPECT_EQ(of(exact(0x1p-1074) / 2), 0);
  EXPECT_EQ(of(exact(0x1p-1074) / 2 + tiny * tiny), 0x1p-1074);
  EXPECT_EQ(of(1, exact(0x1p1023) * exact(0x1p1023) * 9), std::numeric_limits<double>::max());
  EXPECT_EQ(rounded({2, 2}, 2, 2), 2) << "sqrt(2) sqrt(2), on the far side of `rest`";
  // Roots that make |rest - root| the middle of 1 and the next number, and less and more than it by about 2^-900.
  const Rational x = 1 + half_ulp, change = exact(0x1p-900);
  for (const int rest : {0, 4, -1}) {
    const Rational root = rest > 0 ? Rational(rest - x) : Rational(rest + x), square = root * root;
    const Rational away = rest > 0 ? Rational(-change) : change;
    EXPECT_EQ(rounded({rest, square - away}, 0), 1) << rest;
    EXPECT_EQ(rounded({rest, square}, 0), 1) << rest;
    EXPECT_EQ(rounded({rest, square + away}, 0), 1 + 0x1p-52) << rest;
  }
}

// rounded_depth divides the same difference by a length, and knows `rest` - s >= 0 alone.
TEST(RootTime, AnErrorIsRoundedAsADepthIs) {
  constexpr std::uint64_t seed = 23;
  std::mt19937_64 random(seed);
  int compared = 0;
  for (int i = 0; i < 2000; ++i) {
    const MovingQuery<double> q = small_query(random, 1 + i % 4);
    const std::optional<FirstContact> found = first_contact(q);
    const Rational squared = dot(q.d, q.d), s = exact(static_cast<double>(random() % 64) / 64);
    if (!found || squared == 0 || found->time.rest < s) continue;
    ++compared;
    EXPECT_EQ(rounded_apart(found->time, s, apart(found->time, s), squared),
              rounded_depth({found->time.square, found->time.rest - s, 1 / squared}))
        << "seed " << seed << ", query " << i;
  }
  EXPECT_GT(compared, 100);
}

// A contact at or before s is a contact of the motion s D, which is exact here: D is of small integers, s of 24 bits.
int order_until(MovingQuery<double> q, float s) {
  q.d = q.d * static_cast<double>(s);
  return swept_distance_order(q);
}

void expect_times_of_verdicts(int queries, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  int by_a_root = 0, at_a_seam = 0;
  for (int i = 0; i < queries; ++i) {
    MovingQuery<double> q = small_query(random, 1 + i % 4);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", query " << i);
    const std::optional<FirstContact> found = first_contact(q);
    ASSERT_EQ(found.has_value(), swept_distance_order(q) <= 0);
    ASSERT_EQ(start_of(q) == Start::clear, order_until(q, 0) > 0);
    if (!found) continue;
    const float s = rounded_down<float>(found->time);
    ASSERT_LE(compare(found->time, 1), 0);
    ASSERT_GE(compare(found->time, exact(s)), 0);
    ASSERT_EQ(order_until(q, s) <= 0, compare(found->time, exact(s)) == 0);
    if (s < 1) {
      ASSERT_LE(order_until(q, std::nextafter(s, 2.0f)), 0);
    }
    ASSERT_FALSE(found->features.empty());

    q.d = q.d * 2.0;  // half of the time, to the bit
    const RootTime half = first_contact(q).value().time;
    ASSERT_EQ(half.rest, found->time.rest / 2);
    ASSERT_EQ(half.square, found->time.square / 4);
    by_a_root += found->time.square != 0;
    at_a_seam += found->features.size() > 1;
  }
  EXPECT_GT(by_a_root, queries / 50);
  EXPECT_GT(at_a_seam, queries / 50);
}
TEST(FirstContact, IsWhereTheVerdictOfAPartOfTheMotionChanges) { expect_times_of_verdicts(3000, 20261123); }
TEST(FirstContactLong, IsWhereTheVerdictOfAPartOfTheMotionChanges) {
  expect_times_of_verdicts(300000 / TRIAL_DIVISOR, 20261124);
}

}  // namespace
}  // namespace axiscert::moving_sphere
