// Bounds of a depth contain the exact value, for queries of every family, and are narrow where they should be.
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
class DepthRanges : public testing::Test {};
TYPED_TEST_SUITE(DepthRanges, Reals);

// Families with centres on the triangle, where d and r are both near zero, with triangles of almost no area, or with
// numbers of every size: the enclosure may be wide for these.
bool may_be_wide(std::string_view family) {
  // In the last five families slivers are a quarter of the bases, each shared by up to 48 queries.
  for (const std::string_view name :
       {"sliver", "on", "grid", "bits", "nonfinite", "orders", "axes", "inverted", "scaled", "translated"}) {
    if (family == name) return true;
  }
  return false;
}

// Every family in two precisions: 10^5 queries.
TYPED_TEST(DepthRanges, HoldTheDepth) {
  constexpr std::uint64_t count = 3000;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    std::size_t wide = 0;
    for_each_query<TypeParam>(family->name, count, [&](const Query<TypeParam>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      const double exact = depth(q, squared_distance(q));
      const DepthRange range = depth_range(q);
      EXPECT_LE(range.low, exact);
      EXPECT_GE(range.high, exact);
      EXPECT_GE(range.low, 0);
      EXPECT_LE(range.high, 1);
      wide += range.high - range.low > exact / 4 + std::numeric_limits<TypeParam>::epsilon();
    });
    EXPECT_LE(wide, may_be_wide(family->name) ? count : count / 100) << family->name;
  }
}

TYPED_TEST(DepthRanges, OfOnePointAreCertain) {
  const DepthRange nothing = depth_range(Query<TypeParam>{});
  EXPECT_TRUE(nothing.low == 0 && nothing.high <= 1);
  const TypeParam far = std::numeric_limits<TypeParam>::max();
  Query<TypeParam> q{{far, 0, 0}, {far, 1, 0}, {far, 0, 1}, {-far, 0, 0}, 0};
  EXPECT_GE(depth_range(q).high, depth(q, squared_distance(q)));
  EXPECT_GT(depth_range(q).low, 0.99);
}

// Where sizes differ so much that the depth rounds to 1, and just before that.
TYPED_TEST(DepthRanges, AreOneWhereTheDepthRoundsToOne) {
  const TypeParam tiny = std::ldexp(TypeParam(1), -60), small = std::ldexp(TypeParam(1), -20);
  const auto range_of = [](const Query<TypeParam>& q) {
    const DepthRange range = depth_range(q);
    const double exact = depth(q, squared_distance(q));
    EXPECT_LE(range.low, exact);
    EXPECT_GE(range.high, exact);
    return range;
  };
  const auto around = [](TypeParam size, TypeParam r) {
    return Query<TypeParam>{{size, 0, 0}, {0, size, 0}, {0, 0, size}, {0, 0, 0}, r};
  };
  EXPECT_EQ(range_of(around(tiny, 1)).low, 1) << "a triangle that is nothing beside the radius";
  EXPECT_LT(range_of(around(small, 1)).low, 1);
  const auto far_away = [](TypeParam size) {
    return Query<TypeParam>{{1, 0, 0}, {1, size, 0}, {1, 0, size}, {0, 0, 0}, size};
  };
  EXPECT_EQ(range_of(far_away(tiny)).low, 1) << "a triangle and a radius that are nothing beside their distance";
  EXPECT_LT(range_of(far_away(small)).low, 1);
  const DepthRange near_one_vertex = range_of({{1, 0, 0}, {0, 1, 0}, {tiny, 0, 0}, {0, 0, 0}, 2 * tiny});
  EXPECT_GT(near_one_vertex.low, 0);
  EXPECT_LT(near_one_vertex.high, 0x1p-57) << "a vertex is so near: d is no greater";
}

}  // namespace

// The class of an input on the queries of every family: the enclosures never contradict exact arithmetic, and the
// families that are made to be of a class are of it.

namespace {

template <class Real>
class InputClassesOfFamilies : public testing::Test {};
TYPED_TEST_SUITE(InputClassesOfFamilies, Reals);

TYPED_TEST(InputClassesOfFamilies, AreTheSameWithAndWithoutTheFilter) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<TypeParam>(family->name, 2000 / TRIAL_DIVISOR, [&](const Query<TypeParam>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      EXPECT_EQ(shape_classes(q), shape_classes(q, false));
    });
    if (testing::Test::HasFailure()) FAIL() << family->name;
  }
}

TYPED_TEST(InputClassesOfFamilies, AreWhatAFamilyIsMadeToBe) {
  using enum InputClass;
  const std::pair<const char*, InputClass> made[] = {{"repeated", repeated}, {"collinear", collinear}, {"tie", tie}};
  for (const auto& [family, which] : made) {
    for_each_query<TypeParam>(family, 400 / TRIAL_DIVISOR, [&](const Query<TypeParam>& q, std::uint64_t) {
      EXPECT_TRUE(input_classes(q, squared_distance(q)).contains(which)) << family;
    });
  }
  std::uint64_t slivers = 0, far_away = 0, past_the_window = 0;
  const auto count = [](std::uint64_t& n, const char* family, InputClass which) {
    for_each_query<TypeParam>(family, 400,
                              [&](const Query<TypeParam>& q, std::uint64_t) { n += shape_classes(q).contains(which); });
  };
  count(slivers, "sliver", sliver);
  count(far_away, "far", far);
  count(past_the_window, "scale", scale);
  EXPECT_GT(slivers, 200u);
  EXPECT_GT(far_away, 200u);
  EXPECT_GT(past_the_window, 300u);
}

}  // namespace

}  // namespace axiscert
