// The cells off the article's path in exact arithmetic: the published signs wherever they are defined, and where that
// is.
#include <gtest/gtest.h>

#include <random>

#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/formulae_list.h"

namespace axiscert {
namespace {

bool has_word(Formulae formulae, std::string_view word) { return name(formulae).find(word) != std::string_view::npos; }

// Integers from -2 to 2: one query in ten has an equal pair of vertices, a side of 0 or a radius that touches.
Query<float> small_query(std::mt19937_64& random) {
  std::array<float, coordinate_count> v;
  for (float& x : v) x = static_cast<float>(random() % 5) - 2;
  v.back() = std::abs(v.back());
  return from_coordinates(v);
}

// Numbers of 24 bits, beside each other in one query of three.
Query<float> long_query(std::mt19937_64& random) {
  std::array<float, coordinate_count> v;
  for (float& x : v) x = std::ldexp(static_cast<float>(static_cast<std::int32_t>(random() >> 32)), -31);
  if (random() % 3 == 0) v[3] = std::nextafter(v[0], 2.0f), v[4] = v[1], v[5] = v[2];
  v.back() = std::abs(v.back());
  return from_coordinates(v);
}

void expect_published(Formulae formulae, const Query<float>& q) {
  const ExactSides published = exact_sides(q), own = exact_sides(formulae, q);
  const auto defined = static_cast<ComparisonBits>(~own.undefined);
  EXPECT_EQ(own.strict, published.strict & defined) << name(formulae);
  EXPECT_EQ(own.ties, published.ties & defined) << name(formulae);
  EXPECT_EQ(published.strict & own.undefined, 0u) << name(formulae) << ": what is undefined never separates";
  // Undefined: the plane of a zero area where the plane is divided, the line of a repeated vertex where edges are. At
  // degree 4 the side has nothing to divide.
  const Vec3<BinaryNumber> normal = exact_normal(q);
  const bool has_area = !(normal.x.is_zero() && normal.y.is_zero() && normal.z.is_zero());
  const bool is_plane = has_word(formulae, "plane-");
  ComparisonBits expected = 0;
  if (formulae == Formulae::plane_divided_rooted && !has_area)
    expected |= one_bit<ComparisonBits>(Comparison::plane_radius);
  const Vec3<float> vertices[] = {q.a, q.b, q.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<float>&from = vertices[i], &to = vertices[(i + 1) % 3];
    if (from.x != to.x || from.y != to.y || from.z != to.z) continue;
    if (!is_plane && !has_word(formulae, "-divided-")) continue;
    const std::size_t radius = index_of(Comparison::edge_ab_radius) + 2 * i;
    expected |= one_bit<ComparisonBits>(radius);
    if (is_plane || has_word(formulae, "-6")) expected |= one_bit<ComparisonBits>(radius + 1);
  }
  EXPECT_EQ(own.undefined, expected) << name(formulae);
}

TEST(Cells, HaveThePublishedSignsWhereverTheyAreDefined) {
  std::mt19937_64 random(16);  // seed 16
  int cells = 0;
  for (const Formulae formulae : enumerators<Formulae>) {
    if (kind_of(formulae) != FormulaeKind::cell) continue;
    ++cells;
    for (int i = 0; i < 400; ++i) {
      expect_published(formulae, small_query(random));
      expect_published(formulae, long_query(random));
    }
  }
  EXPECT_EQ(cells, 13) << "eleven of the edges, two of the plane";
}

// |N| > r |AB| with |N| = 12, r = 2, |AB| = 4, both times |AB|: 48 > 32. Its errors have no scale.
TEST(Cells, ARootOnTheRightKeepsItsOrderAndHasNoError) {
  const Query<float> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, -3, 0}, 2};
  const ExactSides sides = exact_sides(Formulae::edges_centred_multiplied_rooted_4, q);
  const ExactComparison radius = sides.comparison(index_of(Comparison::edge_ab_radius));
  EXPECT_TRUE(radius.is_times_root && radius.is_rooted);
  EXPECT_EQ(rational(radius.lhs.over), 48 * 48);
  EXPECT_EQ(rational(radius.rhs.over), 32);
  EXPECT_EQ(SideError(12.0f, 8.0f, radius).kind(), SideError::Kind::without_scale);
  EXPECT_FALSE(sides.comparison(index_of(Comparison::edge_ab_side_c)).is_times_root);
}

}  // namespace
}  // namespace axiscert
