// Values on a boundary by filter equal those of exact arithmetic to the bit if the filter gives a result, and it nearly
// always does.
#include "fuzz/sphere_triangle/families/parts/boundary.h"

#include <cstring>
#include <optional>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/measures/nearest_root.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
class NearestRoots : public testing::Test {};
TYPED_TEST_SUITE(NearestRoots, Reals);
template <class Real>
class NearestRootsLong : public testing::Test {};
TYPED_TEST_SUITE(NearestRootsLong, Reals);

// The number of a family's values that the filters left to exact arithmetic.
struct Silent {
  std::uint64_t distances = 0, radii = 0, coordinates = 0;
};

template <class Real>
bool same_bits(Real x, Real y) {
  return std::memcmp(&x, &y, sizeof x) == 0;
}

// The queries of each family include all seven radii, and all nine sides with all three coordinates, in turn.
template <class Real>
Silent compare_with_exact(const Family& family, std::uint64_t count) {
  Silent silent;
  for_each_query<Real>(family.name, count, [&](const Query<Real>& q, std::uint64_t position) {
    if (!is_valid(q)) return;
    const auto count_or_compare = [](std::uint64_t& none, const std::optional<Real>& found, auto&& exactly) {
      if (!found) ++none;
      else EXPECT_PRED2(same_bits<Real>, *found, exactly());
    };
    count_or_compare(silent.distances, nearest_distance(q), [&] { return exact_radius_at_distance(q); });
    const Comparison radius = radius_comparison(static_cast<Axis>(position % axis_count));
    count_or_compare(silent.radii, nearest_tie_radius(q, radius), [&] { return exact_radius_on_boundary(q, radius); });
    std::size_t side = position % 9, i = 0;
    while (comparisons[i].is_radius || side-- > 0) ++i;
    const auto which = static_cast<Comparison>(i);
    const int coordinate = static_cast<int>(position / 9 % 3);
    count_or_compare(silent.coordinates, nearest_tie_coordinate(q, which, coordinate),
                     [&] { return exact_coordinate_on_boundary(q, which, coordinate); });
  });
  return silent;
}

// The permitted share, in thousandths, of distances, radii and coordinates that may be left to exact arithmetic. These
// are roots of zero, triangles without area that is not apparent from an edge and, in binary64, triangles of almost no
// area or numbers of every size.
struct AllowedShares {
  std::string_view family;
  std::uint64_t distances, radii, coordinates;
};
template <class Real>
AllowedShares allowed(std::string_view family) {
  constexpr bool wide = sizeof(Real) == 8;
  const AllowedShares known[] = {{"sliver", wide ? 60u : 2u, wide ? 95u : 40u, wide ? 180u : 60u},
                                 {"needle", wide ? 15u : 1u, 2, 5},
                                 {"collinear", 0, 145, 336},
                                 {"tie", 0, 0, 30},
                                 {"speck", 2, 2, 40},
                                 {"lattice", 12, 50, 110},
                                 {"units", wide ? 25u : 12u, 50, wide ? 150u : 110u},
                                 {"spans", 30, 60, 110},
                                 {"corners", wide ? 90u : 5u, wide ? 90u : 15u, wide ? 90u : 20u},
                                 {"slender", wide ? 90u : 5u, wide ? 90u : 5u, wide ? 90u : 20u},
                                 {"far", 0, 0, 12},
                                 {"scale", 5, 6, 10},
                                 {"on", 573, 573, 0},
                                 {"grid", 600, 600, 50},
                                 {"bits", wide ? 620u : 180u, wide ? 500u : 60u, wide ? 900u : 550u},
                                 {"subnormal", wide ? 100u : 0u, wide ? 80u : 0u, wide ? 45u : 0u},
                                 {"nonfinite", wide ? 400u : 150u, wide ? 400u : 100u, wide ? 400u : 150u},
                                 // Floors and walls along the axes: normals with two zero coordinates.
                                 {"scene-walk", wide ? 0u : 3u, wide ? 0u : 2u, 75},
                                 {"scene-edge", wide ? 0u : 2u, wide ? 0u : 2u, 120},
                                 // One base shared by up to 48 queries: slivers and small integers are a quarter each.
                                 {"orders", 60, 150, 250},
                                 {"axes", 60, 150, 250},
                                 {"inverted", 60, 150, 250},
                                 {"scaled", 60, 150, 250},
                                 {"translated", 60, 150, 250}};
  for (const AllowedShares& a : known) {
    if (a.family == family) return a;
  }
  return {family, 0, 0, 0};  // general, tangent, seam, repeated, ratio
}

template <class Real>
void expect_the_exact_answers(std::uint64_t count) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    const Silent silent = compare_with_exact<Real>(*family, count);
    const AllowedShares most = allowed<Real>(family->name);
    const auto places = [count](std::uint64_t thousandths) { return count * thousandths / 1000 + count / 10000; };
    const auto of = fmt::format(
        " of {} queries of {} left to exact arithmetic; fuzz/queries/boundary_test.cpp, allowed(), says how many may "
        "be",
        count, family->name);
    EXPECT_LE(silent.distances, places(most.distances)) << "distances" << of;
    EXPECT_LE(silent.radii, places(most.radii)) << "radii" << of;
    EXPECT_LE(silent.coordinates, places(most.coordinates)) << "coordinates" << of;
  }
}

TYPED_TEST(NearestRoots, AreTheExactOnes) { expect_the_exact_answers<TypeParam>(3000); }
TYPED_TEST(NearestRootsLong, AreTheExactOnes) { expect_the_exact_answers<TypeParam>(100'000 / TRIAL_DIVISOR); }

TYPED_TEST(NearestRoots, OfZeroAreSeenWhereTheNumbersShowThem) {
  const Query<TypeParam> at_vertex{{1, 2, 3}, {4, 5, 7}, {-1, 0, 2}, {4, 5, 7}, 1};
  EXPECT_EQ(nearest_distance(at_vertex), TypeParam(0));
  EXPECT_EQ(nearest_tie_radius(at_vertex, Comparison::vertex_b_radius), TypeParam(0));
  const Query<TypeParam> repeated{{1, 2, 3}, {1, 2, 3}, {-1, 0, 2}, {4, 5, 7}, 1};
  EXPECT_EQ(nearest_tie_radius(repeated, Comparison::edge_ab_radius), TypeParam(0));
  EXPECT_EQ(nearest_tie_radius(repeated, Comparison::plane_radius), TypeParam(0));
  EXPECT_EQ(nearest_tie_coordinate(repeated, Comparison::vertex_a_side_b, 1), TypeParam(5));
  EXPECT_EQ(nearest_tie_coordinate(repeated, Comparison::edge_bc_side_a, 1), TypeParam(5));
}

// The distance relative to which critical radii are measured, compared with CGAL's.
TYPED_TEST(NearestRoots, AreTheRoundedDistanceOfTheOracle) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<TypeParam>(family->name, 300, [](const Query<TypeParam>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      const auto squared = squared_distance(q);
      EXPECT_EQ(rounded_distance(q), nearest_sqrt<TypeParam>(squared));
      const RadiusRange<TypeParam> range{1, 8};
      EXPECT_EQ(rounded_distance_within(rounded_distance(q), range), distance_within(squared, range));
    });
  }
}

// Roots on a rounding midpoint: no enclosure excludes the midpoint, and the exact root goes to the even neighbour.
TYPED_TEST(NearestRoots, OnAMidpointAreLeftToExactArithmetic) {
  const TypeParam half = std::numeric_limits<TypeParam>::epsilon() / 2;
  const Query<TypeParam> q{{1, -3, -3}, {1, 5, -3}, {1, 0, 5}, {-half, 0, 0}, 0};  // d = 1 + eps / 2
  EXPECT_EQ(nearest_distance(q), std::nullopt);
  EXPECT_EQ(radius_at_distance(q), TypeParam(1));
  EXPECT_EQ(nearest_tie_radius(q, Comparison::plane_radius), std::nullopt);
  const TypeParam even = 1 + 2 * half;
  Query<TypeParam> odd = q;  // d = 1 + 3 eps / 2
  for (auto* v : {&odd.a, &odd.b, &odd.c}) v->x = even;
  EXPECT_EQ(nearest_distance(odd), std::nullopt);
  EXPECT_EQ(radius_at_distance(odd), 1 + 4 * half);
}

// Beyond the greatest float, at it, and among the subnormals.
TYPED_TEST(NearestRoots, AtTheEndsOfTheRange) {
  using Limits = std::numeric_limits<TypeParam>;
  for (const int exponent : {Limits::max_exponent - 1, Limits::max_exponent - 2, Limits::min_exponent - 2,
                             Limits::min_exponent - Limits::digits}) {
    const TypeParam unit = std::ldexp(TypeParam(1), exponent);
    for (const TypeParam x : {TypeParam(0), unit, -unit}) {
      const Query<TypeParam> q{{unit, unit, x}, {unit, -unit, unit}, {x, unit, unit}, {-unit, -x, -unit}, unit};
      const auto d = nearest_distance(q);
      if (d) {
        EXPECT_EQ(*d, exact_radius_at_distance(q)) << exponent;
      }
      for (std::size_t axis = 0; axis < axis_count; ++axis) {
        const Comparison which = radius_comparison(static_cast<Axis>(axis));
        EXPECT_EQ(radius_on_boundary(q, which), exact_radius_on_boundary(q, which)) << exponent;
      }
    }
  }
}

}  // namespace
}  // namespace axiscert
