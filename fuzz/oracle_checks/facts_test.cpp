// Known facts about the published test, each established again by exact computation.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/sphere_triangle/forms/contracted.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> scaled(const Query<Real>& q, int exponent) {
  auto v = coordinates(q);
  for (Real& x : v) x = std::ldexp(x, exponent);
  return from_coordinates(v);
}

AxisBits reference_axes(const Query<float>& q) { return axes_of(bits_of(reference_sides(q), Strictness::strict)); }

// The exponents at which the axis separates a clearly separated query, with everything scaled together.
std::pair<int, int> window(const Query<float>& q, Axis axis) {
  const auto separates = [&](int k) { return has_bit(reference_axes(scaled(q, k)), axis); };
  int low = 0, high = 0;
  while (low > -120 && separates(low - 1)) --low;
  while (high < 120 && separates(high + 1)) ++high;
  return {low, high};
}

TEST(Facts, EdgeAxesLeaveBinary32EarlyAndVertexAxesDoNot) {
  const Query<float> beside_edge{{-1, 2, 0}, {1, 2, 0}, {0, 3, 0}, {0, 0, 0}, 1};
  const auto [edge_low, edge_high] = window(beside_edge, Axis::edge_ab);
  EXPECT_NEAR(edge_high, 20, 2);
  EXPECT_NEAR(edge_low, -27, 4);
  const Query<float> beside_vertex{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 0}, 0.5f};
  const auto [vertex_low, vertex_high] = window(beside_vertex, Axis::vertex_a);
  EXPECT_GE(vertex_high, 30);
  EXPECT_LE(vertex_low, -30);
  // Beyond either end a clear separation is called a contact.
  for (const int k : {edge_high + 1, edge_low - 1}) EXPECT_EQ(reference_axes(scaled(beside_edge, k)), 0) << "2^" << k;
}

// Q.Q = e |A x B|^2 and Q.QC = -e (A x B . V); d = A.V = det(A, B, C) and V = A x B + B x C + C x A.
TEST(Facts, TheEdgeAxesNeedOnlyDegreeFour) {
  for (const char* family : {"general", "bits", "sliver", "repeated"}) {
    for (std::uint64_t position = 0; position < 300; ++position) {
      const Query<float> q = find_family(family).make<float>(4, position);
      const auto t = centred_as<BinaryNumber>(q, [](float x) { return BinaryNumber(static_cast<double>(x)); });
      const ExactSides truth = exact_sides(t);
      const auto normal = cross(t.b - t.a, t.c - t.a);
      const auto sum = cross(t.a, t.b) + cross(t.b, t.c) + cross(t.c, t.a);
      EXPECT_TRUE(normal.x == sum.x && normal.y == sum.y && normal.z == sum.z);
      EXPECT_TRUE(dot(t.a, normal) == dot(t.a, cross(t.b, t.c)));
      const auto expect_edge = [&](const Vec3<BinaryNumber>& x, const Vec3<BinaryNumber>& y, Comparison radius,
                                   Comparison side) {
        const BinaryNumber e = dot(y - x, y - x);
        const Vec3<BinaryNumber> n = cross(x, y);
        EXPECT_TRUE(truth.lhs[index_of(radius)].over == e * dot(n, n)) << family << " " << position;
        EXPECT_TRUE(truth.lhs[index_of(side)].over == BinaryNumber() - e * dot(n, normal)) << family << " " << position;
        // The degree-4 pair has the signs of the published one, e = 0 included.
        EXPECT_EQ(dot(n, n) > t.rr * e, has_bit(truth.strict, radius));
        EXPECT_EQ(dot(n, normal) < BinaryNumber(), has_bit(truth.strict, side));
      };
      using enum Comparison;
      expect_edge(t.a, t.b, edge_ab_radius, edge_ab_side_c);
      expect_edge(t.b, t.c, edge_bc_radius, edge_bc_side_a);
      expect_edge(t.c, t.a, edge_ca_radius, edge_ca_side_b);
    }
  }
}

// cross(u, u) is zero if each product is rounded, and noise if one of the two is fused.
template <class Real>
double deepest_missed_contact_when_contracted() {
  double deepest = 0;
  for (std::uint64_t position = 0; position < 4000; ++position) {
    const Query<Real> q = find_family("repeated").make<Real>(5, position);
    const auto sides = contracted_sides(q);
    const bool separated = axes_of(bits_of(sides, Strictness::strict)) != 0;
    if (separated && distance_order(q) <= 0) deepest = std::max(deepest, depth(q, squared_distance(q)));
  }
  return deepest;
}

TEST(Facts, ContractionMissesContactsDeeplyOnRepeatedVerticesInDoubleToo) {
  EXPECT_GT(deepest_missed_contact_when_contracted<float>(), 0.1);
  EXPECT_GT(deepest_missed_contact_when_contracted<double>(), 0.1);
}

TEST(Facts, TheFloatNearestTheDistanceFlipsAboutAThird) {
  int flips = 0;
  constexpr int count = 3000;
  for (std::uint64_t position = 0; position < count; ++position) {
    Query<float> q = find_family("general").make<float>(6, position);
    q.r = radius_at_distance(q);
    flips += judge_published(q).verdict_flip.has_value();
  }
  EXPECT_GT(flips, count / 5);
  EXPECT_LT(flips, count / 2);
}

TEST(Facts, SliversMissContactsDeeply) {
  double deepest = 0;
  for (std::uint64_t position = 0; position < 60000; ++position) {
    const Query<float> q = find_family("sliver").make<float>(1, position);
    if (distance_order(q) > 0 || reference_axes(q) == 0) continue;
    deepest = std::max(deepest, depth(q, squared_distance(q)));
  }
  EXPECT_GT(deepest, 0.5);
}

}  // namespace
}  // namespace axiscert
