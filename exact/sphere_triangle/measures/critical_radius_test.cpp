// Critical radii of kernels whose answers are known, monotone and not; and limits, exactly and by one float.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "exact/judge/critical_radius.h"
#include "exact/judge/oracles.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
// Queries exactly on a limit, and one float to each side of it.

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

// The triangle (0,0,0) (4,0,0) (0,4,0) faces upwards.
Query<double> at_height(double z, double r) { return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, z}, r}; }

TEST(Limits, TheFrontIsWhereTheNormalPoints) {
  const Limits front{.sides = SidesPolicy::front};
  EXPECT_TRUE(front.any());
  EXPECT_TRUE(is_within(front, at_height(0x1p-1074, 1)));
  for (const double z : {0.0, -0x1p-1074, -3.0}) EXPECT_FALSE(is_within(front, at_height(z, 1))) << z;
  Query<double> turned = at_height(3, 1), line = at_height(3, 1);
  std::swap(turned.b, turned.c);
  line.c = {8, 0, 0};
  EXPECT_FALSE(is_within(front, turned));
  EXPECT_FALSE(is_within(front, line)) << "a triangle without area has no front";
  const Query<double> none = at_height(std::numeric_limits<double>::infinity(), 1);
  EXPECT_TRUE(is_within({.margin = 1, .sides = SidesPolicy::front}, none)) << "no query";
}

TEST(Limits, AMarginIsOpenFromTouchToItsEnd) {
  const Limits quarter{.margin = 0.25};
  EXPECT_TRUE(is_within(quarter, at_height(1, 1))) << "touching is promised";
  EXPECT_TRUE(is_within(quarter, at_height(0.5, 1)));
  EXPECT_FALSE(is_within(quarter, at_height(std::nextafter(1.0, 2), 1)));
  EXPECT_FALSE(is_within(quarter, at_height(1.25, 1))) << "a margin's end is open too";
  EXPECT_TRUE(is_within(quarter, at_height(std::nextafter(1.25, 2), 1)));
  EXPECT_FALSE(is_within(quarter, at_height(0.25, 0))) << "a point";
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

// A kernel whose answer depends on the radius only.
template <class Contact>
Implementation<float> by_radius(Contact contact) {
  return {[contact](const QueryColumns<float>& batch, Verdict* out) {
            for (std::size_t i = 0; i < batch.size; ++i) {
              out[i] = contact(batch.column[12][i]) ? Verdict::contact : Verdict::separated;
            }
          },
          nullptr};
}

const Query<float> at_distance_two{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 0, 0}, 0};

TEST(CriticalRadius, TheExactOneIsTheLeastFloatNotBelowTheDistance) {
  EXPECT_EQ(sqrt_rounded_up<float>(4), 2.f);
  const float root = std::sqrt(3.f);  // rounded down or up: the exact critical radius is not below the root
  const float exact_root = *sqrt_rounded_up<float>(3);
  EXPECT_TRUE(exact_root == root || exact_root == std::nextafter(root, 2.f));
  EXPECT_GE(exact(exact_root) * exact(exact_root), 3);
  const float below = std::nextafter(exact_root, 0.f);
  EXPECT_LT(exact(below) * exact(below), 3);
  const Rational greatest = exact(std::numeric_limits<float>::max());
  EXPECT_EQ(sqrt_rounded_up<float>(greatest * greatest), std::numeric_limits<float>::max());
  EXPECT_FALSE(sqrt_rounded_up<float>(greatest * greatest + 1)) << "rounds to the greatest, lies beyond it";
}

TEST(CriticalRadius, ErrorsAreInUlpsOfTheDistance) {
  EXPECT_EQ(radius_error_ulps(2.f, 2.f, Rational(4)), Decimal6());
  EXPECT_EQ(radius_error_ulps(2.f + 0x1p-21f, 2.f, Rational(4)), round_up(Rational(2)));
  EXPECT_EQ(radius_error_ulps(2.f - 0x1p-23f, 2.f, Rational(4)), round_up(Rational(1, 2))) << "below a power of two";
}

// A kernel that answers except at one radius.
Implementation<float> silent_at(float radius) {
  return {[radius](const QueryColumns<float>& batch, Verdict* out) {
            for (std::size_t i = 0; i < batch.size; ++i) {
              const float r = batch.column[12][i];
              out[i] = r == radius ? Verdict::unanswered : r >= 2 ? Verdict::contact : Verdict::separated;
            }
          },
          nullptr};
}

TEST(CriticalRadius, ARadiusWithoutAnAnswerIsToldFromNoRadius) {
  const float max = std::numeric_limits<float>::max();
  for (const float silent : {max, std::nextafter(2.f, 0.f), 2.f}) {
    EXPECT_EQ(critical_radius(silent_at(silent), at_distance_two), (CriticalRadius<float>{std::nullopt, false}))
        << silent;
    const auto error = critical_radius_error<float>(silent_at(silent), at_distance_two, 4);
    EXPECT_FALSE(error.answered) << silent;
    EXPECT_FALSE(error.ulps) << silent;
  }
  EXPECT_EQ(critical_radius(by_radius([](float) { return false; }), at_distance_two),
            (CriticalRadius<float>{std::nullopt, true}));
  EXPECT_EQ(critical_radius(by_radius([](float r) { return r >= 2; }), at_distance_two),
            (CriticalRadius<float>{2.f, true}));
}

// A kernel that makes no promise beyond 8 may answer anything there.
TEST(CriticalRadius, IsSoughtWithinTheRangeAlone) {
  const auto limited = by_radius([](float r) { return r >= 2 && r <= 8; });
  EXPECT_FALSE(critical_radius(limited, at_distance_two).radius);
  EXPECT_EQ(critical_radius(limited, at_distance_two, {1, 8}).radius, 2.f);
  EXPECT_EQ(critical_radius_error<float>(limited, at_distance_two, 4, {1, 8}).ulps, 0);
  EXPECT_FALSE(critical_radius_error<float>(limited, at_distance_two, 4, {3, 8}).ulps) << "the distance is 2";
  EXPECT_FALSE(critical_radius_error<float>(limited, at_distance_two, 4, {0, 1}).ulps);
  EXPECT_TRUE(critical_radius_error<float>(limited, at_distance_two, 4, {3, 8}).answered);
}

std::optional<RadiusReversal<float>> reversal(const Implementation<float>& kernel, const Query<float>& q,
                                              std::optional<float> critical, std::optional<float> exact_radius) {
  return radius_reversal(kernel, QueryWithRadius<float>{q, coordinate_count - 1}, critical, exact_radius);
}

void expect_reversal(const Implementation<float>& kernel, const std::string& what) {
  const auto found = reversal(kernel, at_distance_two, critical_radius(kernel, at_distance_two).radius, 2.f);
  ASSERT_TRUE(found) << what;
  EXPECT_LT(found->contact, found->separated) << what;
  QueryBatch<float> batch(2, coordinate_count);
  for (const float r : {found->contact, found->separated}) {
    Query<float> q = at_distance_two;
    q.r = r;
    batch.push_back(q);
  }
  Verdict verdicts[2];
  kernel.verdicts(batch.columns(), verdicts);
  EXPECT_EQ(verdicts[0], Verdict::contact) << what;
  EXPECT_EQ(verdicts[1], Verdict::separated) << what;
}

TEST(CriticalRadius, AKernelThatIsNotMonotoneIsFoundWithAValidPair) {
  expect_reversal(by_radius([](float r) { return r >= 2 && r != 2 + 0x1p-20f; }), "a hole four floats above");
  expect_reversal(by_radius([](float r) { return r >= 2 || (r > 0x1p-40f && r < 0x1p-38f); }), "an island far below");
  expect_reversal(by_radius([](float r) { return r >= 2 && r < 0x1p100f; }), "separated beyond a power of two");
  expect_reversal(by_radius([](float r) { return r == 0; }), "contact at zero only: unbounded, and reversed");
}

TEST(CriticalRadius, MonotoneKernelsAreNotAccused) {
  for (const auto& kernel : {by_radius([](float r) { return r >= 2; }), by_radius([](float) { return true; }),
                             by_radius([](float) { return false; })}) {
    EXPECT_FALSE(reversal(kernel, at_distance_two, critical_radius(kernel, at_distance_two).radius, 2.f));
  }
  // Radius sides that grow with r, side comparisons that do not read it.
  std::mt19937_64 random(31);
  for (const char* id : {"published", "nonstrict", "reduced", "ladder-0", "minkowski", "closest-point", "segments"}) {
    const auto kernel = find_kernel(id).on<float>(scalar_target);
    for (int trial = 0; trial < 50; ++trial) {
      std::array<float, coordinate_count> x;
      for (float& v : x) v = std::ldexp(static_cast<float>(static_cast<std::int32_t>(random() >> 32)), -31);
      const auto q = from_coordinates(x);
      const auto exact_radius = sqrt_rounded_up<float>(squared_distance(q));
      EXPECT_FALSE(reversal(kernel, q, critical_radius(kernel, q).radius, exact_radius))
          << id << ", query " << trial << " of seed 31";
    }
  }
}

}  // namespace

}  // namespace axiscert
