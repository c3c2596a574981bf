// Signs by integers on the queries of the families, compared with those of arbitrary precision.
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/grid_signs.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
void expect_exact() {
  constexpr int queries = 4096;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<Real>(family->name, queries, [&](const Query<Real>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      const Signs found = integer_signs(q), exact = signs_of(exact_sides(q));
      EXPECT_EQ(found.strict, exact.strict);
      EXPECT_EQ(found.ties, exact.ties);
    });
    if (testing::Test::HasFailure()) return;
  }
}
TEST(GridSignsOfFamilies, AreExactInBinary32) { expect_exact<float>(); }
TEST(GridSignsOfFamilies, AreExactInBinary64) { expect_exact<double>(); }

}  // namespace

// Distances, depths and lengths by integers on the queries of the families, compared with CGAL's exact distance rounded
// by rationals.

namespace {

template <class Real>
class GridDistances : public testing::Test {};
TYPED_TEST_SUITE(GridDistances, Reals);

TYPED_TEST(GridDistances, AreTheRoundedOnesOfEveryFamily) {
  constexpr std::uint64_t count = 800;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    std::uint64_t silent = 0;
    for_each_query<TypeParam>(family->name, count, [&](const Query<TypeParam>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      const Rational square = squared_distance(q);
      const auto depth_found = depth_on_grid(q);
      const auto distance_found = distance_on_grid(q);
      EXPECT_EQ(depth_found.value_or(depth(q, square)), depth(q, square));
      EXPECT_EQ(distance_found.value_or(nearest_sqrt<TypeParam>(square)), nearest_sqrt<TypeParam>(square));
      const auto length_found = length_on_grid(q);
      const double length = rounded_length(exact_depth(q, square));
      EXPECT_EQ(length_found.value_or(length), length);
      EXPECT_LE(length, LazyDistance<TypeParam>(q, false).length_at_most());
      EXPECT_LE(length, LazyDistance<TypeParam>(q, true).length_at_most());
      silent += !depth_found + !distance_found + !length_found;
    });
    EXPECT_LE(silent, count / 100) << family->name;
    if (testing::Test::HasFailure()) return;
  }
}

// Spheres about a face, about each edge and each vertex, in every vertex order, including centres on these.
TYPED_TEST(GridDistances, AreThoseOfEveryFeature) {
  for (const TypeParam height : {TypeParam(0), TypeParam(1), TypeParam(3)}) {
    for (int x = -2; x <= 6; ++x) {
      for (int y = -2; y <= 6; ++y) {
        const Vec3<TypeParam> v[3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
        const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
        for (const auto& order : orders) {
          const Query<TypeParam> q = {v[order[0]], v[order[1]], v[order[2]], {TypeParam(x), TypeParam(y), height}, 1};
          const Rational square = squared_distance(q);
          ASSERT_EQ(distance_on_grid(q), nearest_sqrt<TypeParam>(square)) << x << ' ' << y << ' ' << height;
          ASSERT_EQ(depth_on_grid(q), depth(q, square)) << x << ' ' << y << ' ' << height;
        }
      }
    }
  }
}

TYPED_TEST(GridDistances, AreThoseOfTrianglesWithoutArea) {
  for (int x = -3; x <= 3; ++x) {
    for (const int second : {-2, 0, 2}) {
      for (const int third : {-2, 0, 1}) {
        const Query<TypeParam> q = {
            {0, 0, 0}, {TypeParam(second), 0, 0}, {TypeParam(third), 0, 0}, {TypeParam(x), 1, 1}, 2};
        const Rational square = squared_distance(q);
        ASSERT_EQ(distance_on_grid(q), nearest_sqrt<TypeParam>(square)) << x << ' ' << second << ' ' << third;
        ASSERT_EQ(depth_on_grid(q), depth(q, square)) << x << ' ' << second << ' ' << third;
      }
    }
  }
}

// |(3k, 4k, 0)| = 5k, an odd number of one bit more than the precision has: numbers close to it are not distinguished
// from it.
TYPED_TEST(GridDistances, SayNothingOfAMidpoint) {
  const TypeParam k = std::ldexp(TypeParam(1), std::numeric_limits<TypeParam>::digits - 2) + 1;
  const auto at = [](TypeParam x, TypeParam y) { return Query<TypeParam>{{x, y, 0}, {x, y, 0}, {x, y, 0}, {}, 1}; };
  EXPECT_EQ(distance_on_grid(at(3 * k, 4 * k)), std::nullopt);
  EXPECT_EQ(distance_on_grid(at(3 * k + 1, 4 * k)), nearest_sqrt<TypeParam>(squared_distance(at(3 * k + 1, 4 * k))));
}

TYPED_TEST(GridDistances, HoldAtBothEndsOfThePrecision) {
  using Limits = std::numeric_limits<TypeParam>;
  const TypeParam least = Limits::denorm_min(), most = Limits::max();
  EXPECT_EQ(distance_on_grid(Query<TypeParam>{}), 0);
  EXPECT_EQ(depth_on_grid(Query<TypeParam>{}), 0);
  const Query<TypeParam> small = {
      {4 * least, 3 * least, 0}, {4 * least, 3 * least, 0}, {4 * least, 3 * least, 0}, {}, least};
  EXPECT_EQ(distance_on_grid(small), 5 * least);
  EXPECT_EQ(depth_on_grid(small), 0.8);
  const Query<TypeParam> wide = {
      {most, most, most}, {most, most, least}, {most, -most, most}, {-most, -most, -most}, least};
  EXPECT_EQ(distance_on_grid(wide), Limits::infinity());
  EXPECT_EQ(depth_on_grid(wide), depth(wide, squared_distance(wide)));
  for (const Query<TypeParam>& q : {small, wide}) {
    const double length = rounded_length(exact_depth(q, squared_distance(q)));
    EXPECT_EQ(length_on_grid(q), length);
    EXPECT_LE(length, LazyDistance<TypeParam>(q, false).length_at_most());
    EXPECT_LE(length, LazyDistance<TypeParam>(q, true).length_at_most());
  }
}

}  // namespace

}  // namespace axiscert
