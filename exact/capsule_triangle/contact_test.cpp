// The numbers of a capsule and a triangle, and the judge of a kernel's: as drawn by hand, by definition, and with each
// fault.
#include "exact/capsule_triangle/contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "exact/judge/oracles.h"
#include "kernel/boxes/names.h"
#include "kernel/capsule_triangle/capsule.h"
#include "kernel/capsule_triangle/contact.h"

namespace axiscert::capsule {
namespace {

using Said = std::array<double, boxes::contact_measures>;
using Query = EndsQuery<double>;

// The capsule lies above the face, with its nearer end at a height of 3 and a radius of 4.
const Query above{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {0, 0, 3}, {2, 0, 5}, 4};
constexpr Said right_above = {-1, 0, 0, -1, 0, 0, -1, 0, 0, 0};
// Its segment goes through the face, by 1 from above; 7 is the way out.
const Query through{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}, {0, 0, 1}, {0, 0, -5}, 6};

ContactJudgement judged(const Query& q, Verdict said, const Said& numbers) {
  const Numbers<double> columns = q;
  return oracles_of(capsule_triangle_predicate()).contact_judge(columns)->judge(said, numbers);
}
ContactJudgement changed(const std::function<void(Said&)>& change, Verdict said = Verdict::contact) {
  Said numbers = right_above;
  change(numbers);
  return judged(above, said, numbers);
}
Said said_of(const Query& q) {
  Said numbers;
  put_contact(q, ExactContact(q).is_apart(), numbers.data());
  return numbers;
}

TEST(CapsuleContact, IsAsDrawn) {
  const ExactContact contact(above);
  EXPECT_FALSE(contact.is_apart());
  EXPECT_TRUE(contact.is_deep());
  EXPECT_EQ(contact.rounded_separation(), -1);
  ASSERT_TRUE(contact.only_normal());
  EXPECT_EQ(contact.only_normal()->x, 0);
  EXPECT_EQ(contact.only_normal()->y, 0);
  EXPECT_LT(contact.only_normal()->z, 0);
  ASSERT_TRUE(contact.only_points());
  EXPECT_EQ(contact.only_points()->b.x, 0);
  EXPECT_EQ(contact.only_points()->b.z, 0);
  const ExactContact deep(through);
  EXPECT_EQ(deep.of_segment().squared_separation(), 1) << "the end that is less deep";
  EXPECT_EQ(deep.rounded_separation(), -7);
  EXPECT_GT(deep.only_normal()->z, 0);
  const Rational scene = deep.squared_scene();
  EXPECT_EQ(compare(exact_depth(through), {0, 7, scene}), 0) << "r and what the segment is in the triangle";
  EXPECT_EQ(rounded_depth(exact_depth(through)), nearest_sqrt<double>(Rational(49 / scene)));
  EXPECT_EQ(compare(exact_depth(above), {0, 1, ExactContact(above).squared_scene()}), 0);
  Query apart = above;
  apart.r = 2;
  EXPECT_TRUE(ExactContact(apart).is_apart());
  EXPECT_EQ(ExactContact(apart).rounded_separation(), 1);
  apart.r = 3;
  EXPECT_EQ(ExactContact(apart).rounded_separation(), 0);
  EXPECT_FALSE(ExactContact(apart).is_deep()) << "it touches";
}

TEST(CapsuleContact, EachFaultHasItsFigure) {
  const ContactJudgement right = changed([](Said&) {});
  EXPECT_EQ(right.consistency, Consistency::consistent);
  EXPECT_TRUE(right.separation->ulps.is_zero());
  EXPECT_EQ(right.normal_angle, 0);
  EXPECT_TRUE(right.pushed->left.is_zero());
  EXPECT_EQ(right.point_a_error, 0);
  EXPECT_EQ(right.point_b_error, 0);
  EXPECT_EQ(right.points_apart, 0);
  const ContactJudgement flipped = changed([](Said& n) { n[3] = 1; });
  EXPECT_TRUE(flipped.pushed->is_flip);
  EXPECT_EQ(flipped.pushed->left.text(), "2");
  EXPECT_EQ(flipped.points_apart, 0) << "the points are right whatever the normal";
  EXPECT_NEAR(changed([](Said& n) { n[1] = 1e-3; }).normal_angle.value(), 1e-3, 1e-9);
  EXPECT_EQ(changed([](Said& n) { n[3] = -2; }).normal_length_error, 1);
  EXPECT_NEAR(changed([](Said& n) { n[0] = -1.005; }).separation->length, 0.005, 1e-15);
  EXPECT_EQ(changed([](Said& n) { n[0] = 1; }).consistency, Consistency::positive);
  EXPECT_EQ(changed([](Said&) {}, Verdict::separated).consistency, Consistency::negative);
  EXPECT_GT(changed([](Said& n) { std::swap_ranges(&n[4], &n[7], &n[7]); }).points_apart.value(), 0.1);
  EXPECT_GT(changed([](Said& n) { n[6] = -2; }).point_a_error.value(), 0.05) << "below the capsule";
  EXPECT_GT(changed([](Said& n) { n[9] = 1; }).point_b_error.value(), 0.05) << "above the triangle";
}

// A segment that touches an edge from beside leaves every direction between the face's and the edge's.
TEST(CapsuleContact, EveryRightChoiceLeavesNothing) {
  const Query touching{{0, 0, 0}, {0, 4, 0}, {-4, 0, 0}, {0, 2, 0}, {3, 2, 0}, 1};
  for (const RationalPoint& n :
       {RationalPoint{-1, 0, 0}, RationalPoint{0, 0, 1}, RationalPoint{0, 0, -1}, RationalPoint{-3, 0, 4}})
    EXPECT_TRUE(ExactContact(touching).left(n).is_zero());
  EXPECT_EQ(ExactContact(touching).left({1, 0, 0}).text(), "1");
  EXPECT_FALSE(ExactContact(touching).only_normal());
  Query along = above;  // all of the segment is as near
  along.p1 = {2, 0, 3};
  for (const double x : {0.0, 1.0, 2.0}) {
    const ContactJudgement found = judged(along, Verdict::contact, {-1, 0, 0, -1, x, 0, -1, x, 0, 0});
    EXPECT_EQ(found.points_apart, 0);
    EXPECT_EQ(found.point_a_error, 0);
    EXPECT_EQ(found.point_b_error, 0);
  }
  EXPECT_FALSE(ExactContact(along).only_points());
  Query on = above;  // a rounding above the face: the normal is anything, and so is the capsule's point
  on.p = {0, 0, 0x1p-60};
  EXPECT_LT(judged(on, Verdict::contact, {-4, 0, 1, 0, 0, 4, 0, 0, 0, 0}).points_apart, 1e-15);
  on.p.z = 0;  // it touches, as a kernel that rounds cannot know
  EXPECT_EQ(judged(on, Verdict::contact, {-4, 0, 1, 0, 0, 4, 0, 0, 0, 0}).points_apart, 0);
  EXPECT_GT(judged(on, Verdict::contact, {-4, 0, 1, 0, 0, 3, 0, 0, 0, 0}).points_apart, 0.05) << "but not so long";
  on.p.z = 1;
  EXPECT_GT(judged(on, Verdict::contact, {-3, 0, 1, 0, 0, 3, 0, 0, 0, 0}).points_apart, 0.1) << "which is no rounding";
}

// The float numbers of the kernel against the exact ones, on small whole numbers and others.
TEST(CapsuleContact, TheKernelsNumbersAreNearTheExactOnes) {
  std::uint64_t state = 20261128;
  const auto whole = [&](int most) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(static_cast<int>(state >> 33) % (2 * most + 1) - most);
  };
  int contacts = 0, crossing = 0;
  for (int i = 0; i < 2000; ++i) {
    const int most = i % 2 == 0 ? 3 : 1000;
    const auto point = [&] { return portable::Vec3<double>{whole(most), whole(most), whole(most)}; };
    const Query q{point(), point(), point(), point(), point(), std::abs(whole(most)) / 2};
    const portable::Vec3<double> normal = cross(q.b - q.a, q.c - q.a);
    if (dot(normal, normal) == 0) continue;
    const ExactContact right(q);
    const ContactJudgement found = judged(q, right.is_apart() ? Verdict::separated : Verdict::contact, said_of(q));
    contacts += !right.is_apart();
    crossing += !right.of_segment().is_apart();
    ASSERT_EQ(found.consistency, Consistency::consistent) << i;
    ASSERT_LT(found.separation->share, 1e-12) << i;
    ASSERT_LT(found.normal_length_error, 1e-12) << i;
    // A segment that touches is a rounding away, in any direction.
    if (found.pushed && right.of_segment().squared_separation() != 0) {
      ASSERT_LT(found.pushed->left.value(), 1e-10) << i;
    }
    ASSERT_LT(std::max({*found.point_a_error, *found.point_b_error, *found.points_apart}), 1e-10) << i;
  }
  EXPECT_GT(contacts, 200);
  EXPECT_GT(crossing, 100);
}

}  // namespace
}  // namespace axiscert::capsule
