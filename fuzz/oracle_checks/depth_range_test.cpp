// Bounds of a depth contain the exact value, for queries of every family, and are narrow where they should be.
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/families/family_testing.h"
#include "kernel/sphere_triangle/description.h"

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
}  // namespace axiscert
