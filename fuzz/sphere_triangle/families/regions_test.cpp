// Spheres seen from each region of a triangle: the feature in turn is the nearest, the verdict is clear, and a method
// that forgets a region or takes the edge by half-planes is wrong on many.
#include <cmath>

#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family_testing.h"
#include "fuzz/sphere_triangle/families/parts/regions.h"

namespace axiscert {
namespace {

template <class Real>
class RegionFamilies : public testing::Test {};
TYPED_TEST_SUITE(RegionFamilies, Reals);

using regions::Corners, regions::Point;

TYPED_TEST(RegionFamilies, HaveTheFeatureInTurnNearest) {
  constexpr std::array<std::string_view, 7> features = {"vertex_a", "vertex_b", "vertex_c", "edge_ab",
                                                        "edge_bc",  "edge_ca",  "face"};
  const NearestFeatures& nearest = *capabilities_of(sphere_triangle_predicate()).nearest_features;
  for (const char* name : {"corners", "slender"}) {
    const Family& family = find_family(name);
    std::uint64_t others = 0;
    const std::uint64_t queries = 30 * regions::count;
    for (std::uint64_t position = 0; position < queries; ++position) {
      const std::size_t region = position % regions::count, feature = regions::is_vertex(region) ? region
                                                                      : regions::is_edge(region) ? 3 + region % 3
                                                                                                 : 6;
      others += nearest.of(family.make<TypeParam>(1, position)) != std::vector{features[feature]};
    }
    EXPECT_LT(others, queries / 50) << name;  // rounding moves some beyond needles
  }
}

double length(const Point& v) { return std::sqrt(dot(v, v)); }

double to_segment(const Point& p, const Point& a, const Point& b) {
  const Point edge = b - a;
  const double foot = std::fmin(std::fmax(dot(p - a, edge) / dot(edge, edge), 0), 1);
  return length(p - (a + edge * foot));
}

// What is forgotten: nothing, a vertex, an edge, or that the first edge that has P outside need not be the nearest.
enum class Forgotten { nothing, vertex, edge, other_edges };

double distance(const Corners& v, const Point& p, Forgotten forgotten, std::size_t which) {
  const Point normal = regions::at_unit_length(cross(v[1] - v[0], v[2] - v[0]));
  double least = INFINITY;
  bool is_outside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point edge = v[shapes::next(i)] - v[i];
    const bool is_out = dot(cross(edge, normal), p - v[i]) > 0;
    const double along = dot(p - v[i], edge) / dot(edge, edge);
    is_outside |= is_out;
    if (forgotten == Forgotten::edge && i == which && along > 0 && along < 1) continue;
    const bool is_first = forgotten == Forgotten::other_edges && is_out;
    const double here = to_segment(p, v[i], v[shapes::next(i)]);
    if (is_first) return here;
    if (forgotten == Forgotten::vertex && length(p - v[which]) == here) continue;
    least = std::fmin(least, here);
  }
  return is_outside ? least : std::fmin(least, std::fabs(dot(normal, p - v[0])));
}

TYPED_TEST(RegionFamilies, SeeForgottenRegions) {
  const Oracles& oracles = oracles_of(sphere_triangle_predicate());
  for (const char* name : {"corners", "slender"}) {
    const Family& family = find_family(name);
    const std::uint64_t queries = 200 * regions::count;
    std::array<std::uint64_t, 8> wrong{};
    std::uint64_t clear = 0;
    for (std::uint64_t position = 0; position < queries; ++position) {
      const Numbers<TypeParam> numbers = family.make<TypeParam>(1, position);
      const std::optional<Verdict> verdict = oracles.clear_verdict(numbers);
      if (!verdict) continue;
      ++clear;
      const Query<TypeParam> q = query_from(numbers);
      const Corners v = {regions::wide(q.a), regions::wide(q.b), regions::wide(q.c)};
      const auto differs = [&](Forgotten forgotten, std::size_t which) {
        const bool is_apart = distance(v, regions::wide(q.p), forgotten, which) > static_cast<double>(q.r);
        return is_apart != (*verdict == Verdict::separated);
      };
      wrong[0] += differs(Forgotten::nothing, 0);
      for (std::size_t k = 0; k < 3; ++k) {
        wrong[1 + k] += differs(Forgotten::vertex, k);
        wrong[4 + k] += differs(Forgotten::edge, k);
      }
      wrong[7] += differs(Forgotten::other_edges, 0);
    }
    EXPECT_GT(clear, queries / 4) << name;  // of slivers in binary32 few are
    EXPECT_EQ(wrong[0], 0u) << name;
    for (std::size_t k = 1; k < 8; ++k) EXPECT_GT(wrong[k], 10u) << name << ", forgotten " << k;
  }
}

}  // namespace
}  // namespace axiscert
