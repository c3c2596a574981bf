// The families whose queries are solved onto a boundary lie on it, and make the published kernel flip where they claim.
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/steps.h"
#include "fuzz/families/family_testing.h"

namespace axiscert {
namespace {

template <class Real>
class FamilyBoundaries : public testing::Test {};
TYPED_TEST_SUITE(FamilyBoundaries, Reals);

constexpr std::array<Comparison, 9> side_comparison = {
    Comparison::vertex_a_side_b, Comparison::vertex_a_side_c, Comparison::vertex_b_side_a,
    Comparison::vertex_b_side_c, Comparison::vertex_c_side_a, Comparison::vertex_c_side_b,
    Comparison::edge_ab_side_c,  Comparison::edge_bc_side_a,  Comparison::edge_ca_side_b};

// P lies in the region of the feature that the axis is named after: its boundary is the distance.
TYPED_TEST(FamilyBoundaries, TangentRadiusIsWithinFourUlpOfTheDistance) {
  std::size_t outside_region = 0;
  for_each_query<TypeParam>("tangent", 7 * 9 * 40, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const int ulps = static_cast<int>(position / 7 % 9) - 4;
    EXPECT_EQ(q.r, step_radius(radius_on_boundary(q, radius_comparison(static_cast<Axis>(position % 7))), ulps));
    outside_region += q.r != step_radius(nearest_sqrt<TypeParam>(squared_distance(q)), ulps);
  });
  EXPECT_LE(outside_region, 7u * 9 * 40 / 500) << "rounding the centre moved it out of its region";
}

TYPED_TEST(FamilyBoundaries, TangentFlipsBothWaysOnEveryAxis) {
  std::array<std::size_t, axis_count> false_separations{}, missed{};
  for_each_query<TypeParam>("tangent", 7 * 9 * 300, [&](const Query<TypeParam>& q, std::uint64_t) {
    const Judgement judgement = judge_published(q);
    for (const Flip& flip : judgement.flips()) {
      if (flip.level != Level::axis || !flip.decisive) continue;
      EXPECT_EQ(flip.links, LinkSet{Link::rounding});
      ++(flip.kind == FlipKind::false_separation ? false_separations : missed)[flip.index];
    }
  });
  for (std::size_t i = 0; i < axis_count; ++i) {
    EXPECT_GE(false_separations[i], 1u) << axis_names[i];
    EXPECT_GE(missed[i], 1u) << axis_names[i];
  }
}

// One coordinate of P is within a few floats of the exact root: the margin changes sign within those.
TYPED_TEST(FamilyBoundaries, SeamCentreIsWithinFourUlpOfASideBoundary) {
  for_each_query<TypeParam>("seam", 9 * 2 * 9 * 5, [](const Query<TypeParam>& q, std::uint64_t position) {
    const Comparison side = side_comparison[position % 9];
    bool changes = false;
    for (TypeParam Vec3<TypeParam>::*coordinate : {&Vec3<TypeParam>::x, &Vec3<TypeParam>::y, &Vec3<TypeParam>::z}) {
      Query<TypeParam> below = q, above = q;
      below.p.*coordinate = step_ulps(q.p.*coordinate, -5);
      above.p.*coordinate = step_ulps(q.p.*coordinate, 5);
      changes |= has_bit(exact_sides(below).strict, side) != has_bit(exact_sides(above).strict, side);
    }
    EXPECT_TRUE(changes) << info(side).name;
    if (position / 9 % 2 == 0) {
      const TypeParam distance = radius_at_distance(q);
      EXPECT_TRUE(q.r >= step_radius(distance, -2) && q.r <= step_radius(distance, 2));
    }
  });
}

// At most 2^18 queries, as in a run; a few tens of thousands are enough.
TYPED_TEST(FamilyBoundaries, SeamFlipsEverySideDecisively) {
  const Family& family = find_family("seam");
  ComparisonBits flipped = 0;
  for (std::uint64_t position = 0; position < (1 << 18) && flipped != side_comparisons; ++position) {
    const ComparisonBits decisive =
        judge_published(query_from(family.make<TypeParam>(1, position))).comparison_decisive;
    flipped = static_cast<ComparisonBits>(flipped | (decisive & side_comparisons));
  }
  EXPECT_EQ(flipped, side_comparisons);
}

}  // namespace
}  // namespace axiscert
