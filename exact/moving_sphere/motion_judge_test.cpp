// The judge of times, features, normals and points, on motions that are worked out by hand.
#include "exact/moving_sphere/motion_judge.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "exact/moving_sphere/first_contact.h"

namespace axiscert::moving_sphere {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

// A sphere of radius r falls from z = 3 to z = -1 onto a wide triangle in z = 0: it touches at z = r.
MovingQuery<double> falling(double r) { return {{-10, -10, 0}, {10, -10, 0}, {0, 10, 0}, {0, 0, 3}, {0, 0, -4}, r}; }
const double falling_scene = std::sqrt(209.0);  // from P to A

// Past a triangle that is one point, half a radius off the path: in contact where |4 t - 2| <= sqrt(3)/2.
const MovingQuery<double> passing = {{2, 0.5, 0}, {2, 0.5, 0}, {2, 0.5, 0}, {0, 0, 0}, {4, 0, 0}, 1};

template <class Real = float>
ContactJudgement judged(const MovingQuery<double>& q, std::initializer_list<double> measures) {
  const std::vector<double> given = measures;
  return FirstContactJudge<Real>(q).judge(Verdict::contact, given);
}
TimeVerdict time_of(const MovingQuery<double>& q, double time) { return judged(q, {time}).time.value(); }

float above(float x) { return std::nextafter(x, 2.0f); }
float below(float x) { return std::nextafter(x, -1.0f); }

TEST(FirstContactJudge, TheBestTimeIsTheGreatestThatIsNotLate) {
  EXPECT_EQ(time_of(falling(1), 0.5), TimeVerdict::best);
  EXPECT_EQ(time_of(falling(1), above(0.5f)), TimeVerdict::late);
  EXPECT_EQ(time_of(falling(1), below(0.5f)), TimeVerdict::early);
  EXPECT_EQ(judged<double>(falling(1), {below(0.5f)}).time, TimeVerdict::early);
}

TEST(FirstContactJudge, AnIrrationalTimeHasTwoFloatsAroundIt) {
  const auto best = static_cast<float>(0.28349364905389035);  // (2 - sqrt(3)/2) / 4
  const float not_late = static_cast<double>(best) > 0.28349364905389035 ? below(best) : best;
  EXPECT_EQ(time_of(passing, not_late), TimeVerdict::best);
  EXPECT_EQ(time_of(passing, above(not_late)), TimeVerdict::late);
  EXPECT_EQ(time_of(passing, below(not_late)), TimeVerdict::early);
  const ContactJudgement late = judged(passing, {above(not_late)});
  EXPECT_GT(late.ulps.value(), 0);
  EXPECT_LT(late.ulps.value(), 1);
}

TEST(FirstContactJudge, ErrorsAreInUlpsOfTheBestTimeAndInU) {
  // An ulp of 1/2 is 2^-24 = u; the float below is half of that away.
  const ContactJudgement late = judged(falling(1), {above(0.5f)}), early = judged(falling(1), {below(0.5f)});
  EXPECT_EQ(late.ulps.value(), 1);
  EXPECT_EQ(late.in_u.value(), 1);
  EXPECT_EQ(early.ulps.value(), 0.5);
  EXPECT_EQ(early.in_u.value(), 0.5);
  EXPECT_EQ(judged(falling(1), {1}).ulps.value(), 8.38861e6) << "2^23 ulps, rounded up to six digits";
}

// The digits of passing's times: 1/2 -+ sqrt(3)/8.
TEST(FirstContactJudge, ErrorsAreAShareOfTheWayAndALengthToo) {
  const auto off = [](const MovingQuery<double>& q, double time) {
    const ContactJudgement found = judged(q, {time});
    return std::array{found.share, found.length};
  };
  EXPECT_EQ(off(falling(1), 1), (std::array{0.5, 2.0}));
  EXPECT_EQ(off(falling(1), 0.125), (std::array{0.375, 1.5})) << "early";
  EXPECT_EQ(off(falling(1), above(0.5f)), (std::array{0x1p-24, 0x1p-22}));
  EXPECT_EQ(off(falling(1), 0.5), (std::array{0.0, 0.0})) << "the best";
  EXPECT_EQ(off(passing, 1), (std::array{0.71650635094610966169093079268823, 2.8660254037844386467637231707529}));
  EXPECT_EQ(off(passing, 0), (std::array{0.28349364905389033830906920731177, 1.1339745962155613532362768292471}));
  MovingQuery<double> slanted = falling(1);
  slanted.d = {1, 1, -4};
  EXPECT_EQ(off(slanted, 1), (std::array{0.5, 2.1213203435596425732025330863145})) << "half of sqrt(18)";
  slanted.d = {0, 0, 0};
  slanted.r = 4;
  EXPECT_EQ(off(slanted, 0.75), (std::array{0.75, 0.0})) << "a motion that stands still";
  // By its ends: D = 1 - 2^60, which is no double, and the contact is a unit before the end.
  const EndsQuery<double> ends{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0x1p60}, {1, 1, 1}, 2};
  const std::vector<double> end = {1};
  EXPECT_EQ(FirstContactJudge<double>(ends).judge(Verdict::contact, end).length, 1);
}

TEST(FirstContactJudge, ATunnelIsHowFarTheSphereGoesInBefore) {
  const auto tunnel = [](double r, double time) { return judged(falling(r), {time}).tunnel.value(); };
  EXPECT_EQ(tunnel(1, 0.625).depth.value(), 0.5);  // z = 1/2
  EXPECT_FALSE(tunnel(1, 0.625).is_through);
  EXPECT_EQ(tunnel(1, above(0.5f)).depth.value(), 2.38418e-7) << "2^-22, rounded down to six digits";
  for (const double time : {0.75, 1.0}) {
    EXPECT_EQ(tunnel(1, time).depth.value(), 1) << time;
    EXPECT_TRUE(tunnel(1, time).is_through) << time;
  }
  EXPECT_FALSE(tunnel(1, below(0.75f)).is_through);
  EXPECT_LT(tunnel(1, below(0.75f)).depth.value(), 1);
  EXPECT_TRUE(tunnel(0, 1).is_through) << "a point that is late is beyond";
  EXPECT_FALSE(judged(falling(1), {0.25}).tunnel) << "early";
}

TEST(FirstContactJudge, TheRootOfTheWrongSignTunnels) {
  const ContactJudgement left = judged(passing, {0.71650635});  // where the sphere leaves
  EXPECT_EQ(left.time, TimeVerdict::late);
  EXPECT_EQ(left.tunnel->depth.value(), 0.5);
}

TEST(FirstContactJudge, AMissIsATunnelOfTheWholeMotion) {
  EXPECT_EQ(FirstContactJudge<float>(passing).judge(Verdict::separated, {}).missed->depth.value(), 0.5);
  EXPECT_TRUE(FirstContactJudge<float>(falling(1)).judge(Verdict::separated, {}).missed->is_through);
  EXPECT_TRUE(FirstContactJudge<double>(falling(0)).judge(Verdict::separated, {}).missed->is_through);
  // Touching at the end is missed by nothing.
  const MovingQuery<double> grazing = {{-10, -10, 0}, {10, -10, 0}, {0, 10, 0}, {0, 0, 3}, {0, 0, -2}, 1};
  EXPECT_TRUE(FirstContactJudge<float>(grazing).judge(Verdict::separated, {}).missed->depth.is_zero());
}

TEST(FirstContactJudge, AGapIsWhatIsLeftAtAnEarlyTime) {
  EXPECT_EQ(judged(falling(1), {0.25}).gap, 1 / falling_scene);
  EXPECT_EQ(judged(falling(1), {0.0}).gap, 2 / falling_scene);
  EXPECT_EQ(judged(falling(1), {0.5}).gap, 0);
}

TEST(FirstContactJudge, WhatIsNoTimeIsSaid) {
  EXPECT_EQ(time_of(falling(1), nan), TimeVerdict::none);
  for (const double time : {infinity, -infinity, -0x1p-149, 1 + 0x1p-23, 3e38}) {
    EXPECT_EQ(time_of(falling(1), time), TimeVerdict::invalid) << time;
  }
  EXPECT_EQ(time_of(falling(1), -0.0), TimeVerdict::early) << "-0 is 0";
  EXPECT_FALSE(judged(falling(1), {}).time) << "a kernel without times";
}

TEST(FirstContactJudge, AnOverlapAtTheStartIsAtTimeZero) {
  EXPECT_EQ(time_of(falling(4), 0.0), TimeVerdict::best);
  EXPECT_EQ(time_of(falling(4), 0x1p-149), TimeVerdict::late);
  EXPECT_EQ(judged<double>(falling(3), {0.0}).time, TimeVerdict::best) << "touching";
}

TEST(FirstContactJudge, AFeatureHasToBeNearestAtTheFirstContact) {
  const auto feature = [](double number) { return judged(falling(1), {0.5, number}).feature_is_right; };
  EXPECT_EQ(feature(6), true);
  for (const double wrong : {0.0, 5.0, 7.0, 5.5, -1.0, infinity}) EXPECT_EQ(feature(wrong), false) << wrong;
  EXPECT_FALSE(feature(nan));
  EXPECT_FALSE(judged(falling(1), {0.5}).feature_is_right);
  for (const double vertex : {0.0, 1.0, 2.0}) EXPECT_EQ(judged(passing, {0.5, vertex}).feature_is_right, true);
}

TEST(FirstContactJudge, AWrongFeatureIsOffByItsRegion) {
  const auto off = [](const MovingQuery<double>& q, double number) { return judged(q, {0.5, number}).feature_error; };
  EXPECT_FALSE(off(falling(1), 6)) << "right";
  EXPECT_DOUBLE_EQ(off(falling(1), 3).value(), 10 / falling_scene) << "10 inside the edge ab";
  // The region of a ends where AB and AC do: the centre is 10 beyond along AB, and 30 / sqrt(5) along AC.
  EXPECT_DOUBLE_EQ(off(falling(1), 0).value(), 30 / std::sqrt(5.0) / falling_scene);
  EXPECT_TRUE(std::isinf(off(falling(1), 7).value())) << "no part";
  MovingQuery<double> beside = falling(1);
  beside.p.y = -14;  // past the edge ab by 4, of which it touches nothing
  beside.r = 5;
  EXPECT_TRUE(judged(beside, {0.5, 3}).feature_is_right.value());
  EXPECT_DOUBLE_EQ(off(beside, 6).value(), 4 / std::sqrt(24.0 * 24 + 3 * 3)) << "4 outside the face";
  EXPECT_EQ(off(passing, 3).value_or(-1), 0) << "a triangle without edges has no planes";
}

TEST(FirstContactJudge, AMeasureThatIsMissingIsSaidButForAnOverlapAtTheStart) {
  const ContactJudgement found = judged(falling(1), {0.5, nan, nan, nan, nan, nan, nan, nan}),
                         inside = judged(falling(4), {0, nan, nan, nan, nan, nan, nan, nan}),
                         point = judged(falling(0), {0.75, nan, nan, nan, nan, nan, nan, nan});
  EXPECT_TRUE(found.lacks_feature && found.lacks_normal && found.lacks_point);
  EXPECT_FALSE(inside.lacks_feature || inside.lacks_normal || inside.lacks_point);
  EXPECT_FALSE(point.lacks_normal) << "at the distance 0 there is none";
  EXPECT_TRUE(point.lacks_feature && point.lacks_point);
  EXPECT_FALSE(judged(falling(1), {0.5}).lacks_feature) << "the kernel gives none anywhere";
}

TEST(FirstContactJudge, ANormalIsJudgedByItsLengthToo) {
  const auto off = [](double z) { return judged(falling(1), {0.5, 6, 0, 0, z}).normal_length_error; };
  EXPECT_EQ(off(1), 0);
  EXPECT_DOUBLE_EQ(off(7).value(), 6);
  EXPECT_DOUBLE_EQ(off(1 - 0x1p-50).value(), 0x1p-50) << "nothing cancels";
  EXPECT_EQ(off(0), 1);
  EXPECT_FALSE(off(nan));
}

TEST(FirstContactJudge, ANormalIsJudgedByItsAngle) {
  const auto angle = [](double x, double y, double z) { return judged(falling(1), {0.5, 6, x, y, z}).normal_angle; };
  EXPECT_EQ(angle(0, 0, 1), 0);
  EXPECT_EQ(angle(0, 0, 7), 0) << "its length is judged apart";
  EXPECT_DOUBLE_EQ(angle(1, 0, 0).value(), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(angle(0, 0, -1).value(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(angle(0, 0, 0).value(), std::numbers::pi);
  EXPECT_DOUBLE_EQ(angle(0x1p-30, 0, 1).value(), 0x1p-30);
  EXPECT_FALSE(angle(nan, nan, nan));
  EXPECT_FALSE(judged(falling(0), {0.75, 6, 0, 0, 1}).normal_angle) << "no distance, no normal";
}

TEST(FirstContactJudge, APointIsJudgedByItsDistance) {
  const auto error = [](double x, double z) { return judged(falling(1), {0.5, 6, 0, 0, 1, x, 0, z}).point_error; };
  EXPECT_EQ(error(0, 0), 0);
  EXPECT_DOUBLE_EQ(error(3, 4).value(), 5 / falling_scene);
  EXPECT_FALSE(error(nan, 0));
}

// A normal and a point seen from the sphere of `passing`: the contact is at the vertex, the normal irrational.
TEST(FirstContactJudge, AnIrrationalContactHasItsNormal) {
  const double x = -std::sqrt(3.0) / 2;
  const ContactJudgement found = judged<double>(passing, {0.28349364905389035, 0, x, -0.5, 0, 2, 0.5, 0});
  EXPECT_LT(found.normal_angle.value(), 1e-15);
  EXPECT_EQ(found.point_error.value(), 0);
}

TEST(MotionPolicy, APromiseIsDecidedExactly) {
  const MotionPolicy whole, front{.sides = SidesPolicy::front}, still{.still = StillPolicy::ignored},
      none{.start = StartPolicy::ignored}, approaching{.start = StartPolicy::approaching};
  MovingQuery<double> down = falling(1), up = falling(1), rest = falling(1), over = falling(1);
  up.d = {0, 0, 4};
  rest.d = {0, 0, 0};
  over.d = {4, 0, 0x1p-1000};  // along the face, by a hair away from it
  for (const auto& q : {down, up, rest, over}) EXPECT_TRUE(is_promised(whole, q) && is_promised(none, q));
  EXPECT_TRUE(is_promised(front, down));
  for (const auto& q : {up, rest, over}) EXPECT_FALSE(is_promised(front, q));
  EXPECT_TRUE(is_promised(still, over));
  EXPECT_FALSE(is_promised(still, rest));
  // The start touches or overlaps.
  for (const double r : {3.0, 4.0}) {
    for (auto* q : {&down, &up, &rest, &over}) q->r = r;
    for (const auto& q : {down, up, rest, over}) EXPECT_FALSE(is_promised(none, q));
    EXPECT_TRUE(is_promised(approaching, down));
    for (const auto& q : {up, rest, over}) EXPECT_FALSE(is_promised(approaching, q));
  }
}

TEST(Sizes, ARootIsBelowAndNear) {
  for (const Rational& q : {Rational(2), Rational(1, 3), exact(0x1p-1000), exact(0x1.8p900), Rational(0)}) {
    const Rational root = root_below(q), above = root * (1 + exact(0x1p-250));
    EXPECT_LE(Rational(root * root), q);
    EXPECT_GE(Rational(above * above), q);
  }
}

// The decimal of a tunnel is the greatest of six digits that it reaches, also beside one that it only just reaches.
TEST(Sizes, ATunnelIsRoundedDownToSixDigits) {
  const Rational quarter(1, 4);  // least distance 1/2 of 1
  EXPECT_EQ(tunnel_of(1, quarter).depth.value(), 0.5);
  EXPECT_EQ(tunnel_of(1, quarter + exact(0x1p-200)).depth.value(), 0.499999);
  EXPECT_EQ(tunnel_of(1, quarter - exact(0x1p-200)).depth.value(), 0.5);
  EXPECT_EQ(tunnel_of(1, times_power(Rational(1), -2000)).depth.value(), 0.999999);
  EXPECT_TRUE(tunnel_of(1, 1).depth.is_zero());
}

}  // namespace
}  // namespace axiscert::moving_sphere
