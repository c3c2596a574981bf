// The rungs of the derivation: their sides against hand computations, the last rung against the published test, and NaN
// in the packed form.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/ladder.h"
#include "kernel/sphere_triangle/forms/reduced.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::for_each_vertex_order, testing_support::random_query,
    testing_support::same, testing_support::sides_in;
using enum Comparison;

template <class Real>
class RungsTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(RungsTest, Reals);

TYPED_TEST(RungsTest, TheLastRungIsThePublishedTestBitForBit) {
  constexpr std::uint64_t seed = 20101231;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i) {
    const auto q = random_query<TypeParam>(random, i % 2 == 1);
    Sides<TypeParam> published, last;
    for (const Strictness strictness : {Strictness::strict, Strictness::nonstrict, Strictness::not_less}) {
      ASSERT_EQ(reference(Formulae::ladder_9, Arithmetic::plain, strictness, q, &last),
                reference(Formulae::published, Arithmetic::plain, strictness, q, &published))
          << "query " << i << " of seed " << seed;
    }
    for (std::size_t k = 0; k < comparison_count; ++k) {
      ASSERT_TRUE(same(last.lhs[k], published.lhs[k]) && same(last.rhs[k], published.rhs[k]))
          << "query " << i << " of seed " << seed << " " << comparisons[k].name;
    }
  }
}

// The edges AB, BC and CA as the article writes them, form by form: what the cells' one text has to give again.
enum class Article { rooted, squared, scaled, undivided, centred };

template <Article form, class Real>
struct EdgeSides {
  Real radius_lhs, radius_rhs, side_lhs, side_rhs;

  EdgeSides(Vec3<Real> A, Vec3<Real> B, Vec3<Real> C, Vec3<Real> P, Real r) {
    using enum Article;
    if (form == centred) A = A - P, B = B - P, C = C - P;
    const Vec3<Real> AB = B - A;
    const Real d = form == centred ? dot(A, AB) : dot(P - A, AB), e = dot(AB, AB), rr = r * r;
    side_lhs = side_rhs = 0;
    if (form == centred) {
      const Vec3<Real> Q = A * e - AB * d;
      radius_lhs = dot(Q, Q), radius_rhs = rr * e * e, side_lhs = dot(Q, C * e - Q);
    } else if (form == undivided) {
      const Vec3<Real> Q = A * e + AB * d, QP = P * e - Q;
      radius_lhs = dot(QP, QP), radius_rhs = rr * e * e, side_rhs = dot(QP, C * e - Q);
    } else {
      const Vec3<Real> Q = A + AB * (d / e);
      Vec3<Real> QP = P - Q, QC = C - Q;
      if (form == scaled) QP = QP * e, QC = QC * e;
      radius_lhs = form == rooted ? std::sqrt(dot(QP, QP)) : dot(QP, QP);
      radius_rhs = form == rooted ? r : form == squared ? rr : rr * e * e;
      side_rhs = dot(QP, QC);
    }
  }
};

template <Article form, class Real>
void expect_article(Formulae formulae, const Query<Real>& q, int query) {
  Sides<Real> found;
  reference(formulae, Arithmetic::plain, Strictness::strict, q, &found);
  const Vec3<Real> v[] = {q.a, q.b, q.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const EdgeSides<form, Real> edge(v[i], v[(i + 1) % 3], v[(i + 2) % 3], q.p, q.r);
    const std::size_t radius = index_of(edge_ab_radius) + 2 * i;
    EXPECT_TRUE(same(found.lhs[radius], edge.radius_lhs) && same(found.rhs[radius], edge.radius_rhs) &&
                same(found.lhs[radius + 1], edge.side_lhs) && same(found.rhs[radius + 1], edge.side_rhs))
        << name(formulae) << ", edge " << i << ", query " << query;
  }
}

TYPED_TEST(RungsTest, TheArticlesEdgesAreCellsBitForBit) {
  using Real = TypeParam;
  std::mt19937_64 random(51);  // seed 51
  for (int i = 0; i < 20000; ++i) {
    const auto q = random_query<Real>(random, i % 2 == 1);
    expect_article<Article::rooted>(Formulae::ladder_4, q, i);
    expect_article<Article::squared>(Formulae::ladder_5, q, i);
    expect_article<Article::scaled>(Formulae::ladder_6, q, i);
    expect_article<Article::undivided>(Formulae::ladder_7, q, i);
    expect_article<Article::centred>(Formulae::ladder_8, q, i);
    const auto reduced = sides_of<portable::ReducedFormulae>(problem_as<Real>(q, [](Real x) { return x; }));
    using Cell = rungs::EdgesCell<rungs::Frame::centred, rungs::Division::multiplied, rungs::Root::squared,
                                  rungs::EdgeDegree::four>;
    const auto cell = sides_of<Cell>(problem_as<Real>(q, [](Real x) { return x; }));
    for (std::size_t k = 0; k < comparison_count; ++k) {
      ASSERT_TRUE(same(cell.lhs[k], reduced.lhs[k]) && same(cell.rhs[k], reduced.rhs[k]))
          << "reduced, query " << i << " " << comparisons[k].name;
    }
  }
}

struct Pair {
  double lhs, rhs;
  bool operator==(const Pair&) const = default;
};
void PrintTo(const Pair& p, std::ostream* out) { *out << p.lhs << " > " << p.rhs; }

// One comparison of a kernel on the right triangle (0,0,0) (4,0,0) (0,4,0).
template <class Real>
Pair sides_at(std::string_view kernel, Vec3<Real> p, Real r, Comparison which) {
  const Sides<Real> sides = sides_in<Real>(find_kernel(kernel), {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, r});
  return {sides.lhs[which], sides.rhs[which]};
}

// Centre (1, 1, 3), r = 2: V = (0, 0, 16), A.V = -48, V.V = 256.
TYPED_TEST(RungsTest, ThePlaneLosesItsRootThenItsDivision) {
  const auto plane = [](std::string_view id) { return sides_at<TypeParam>(id, {1, 1, 3}, 2, plane_radius); };
  EXPECT_EQ(plane("ladder-0"), (Pair{3, 2}));  // |A.N|, r
  EXPECT_EQ(plane("ladder-1"), (Pair{9, 4}));
  EXPECT_EQ(plane("ladder-2"), (Pair{9, 4}));
  for (const char* id : {"ladder-3", "ladder-9", "reduced", "reduced-along", "reduced-determinant", "reduced-shared"}) {
    EXPECT_EQ(plane(id), (Pair{9 * 256, 4 * 256})) << id;
  }
}

// Centre (-3, -4, 0), r = 2: A = (3, 4, 0), B = (7, 4, 0), |A| = 5, A.B = 37.
TYPED_TEST(RungsTest, TheVerticesLoseTheirRootAndDistribute) {
  const auto at = [](std::string_view id, Comparison c) { return sides_at<TypeParam>(id, {-3, -4, 0}, 2, c); };
  EXPECT_EQ(at("ladder-3", vertex_a_radius), (Pair{5, 2}));
  EXPECT_EQ(at("ladder-3", vertex_a_side_b), (Pair{12, 0}));  // (B - A).A
  for (const char* id : {"ladder-4", "ladder-9", "reduced"}) {
    EXPECT_EQ(at(id, vertex_a_radius), (Pair{25, 4})) << id;
    EXPECT_EQ(at(id, vertex_a_side_b), (Pair{37, 25})) << id;
  }
}

// Centre (1, -3, 0), r = 2: the foot on AB is (1, 0, 0), e = 16; N = A x AB = (0, 0, -12), V = (0, 0, 16).
TYPED_TEST(RungsTest, TheEdgesAreSquaredScaledUndividedCentredAndReduced) {
  const auto radius = [](std::string_view id) { return sides_at<TypeParam>(id, {1, -3, 0}, 2, edge_ab_radius); };
  const auto side = [](std::string_view id) { return sides_at<TypeParam>(id, {1, -3, 0}, 2, edge_ab_side_c); };
  EXPECT_EQ(radius("ladder-4"), (Pair{3, 2}));
  EXPECT_EQ(radius("ladder-5"), (Pair{9, 4}));
  for (const char* id : {"ladder-4", "ladder-5"}) EXPECT_EQ(side(id), (Pair{0, -12})) << id;  // QP.QC
  for (const char* id : {"ladder-6", "ladder-7"}) EXPECT_EQ(side(id), (Pair{0, -12 * 256})) << id;
  for (const char* id : {"ladder-6", "ladder-7", "ladder-8", "ladder-9"}) {
    EXPECT_EQ(radius(id), (Pair{9 * 256, 4 * 256})) << id;
  }
  for (const char* id : {"ladder-8", "ladder-9"}) EXPECT_EQ(side(id), (Pair{12 * 256, 0})) << id;
  for (const char* id : {"reduced", "reduced-along", "reduced-determinant", "reduced-shared"}) {
    EXPECT_EQ(radius(id), (Pair{9 * 16, 4 * 16})) << id;
    EXPECT_EQ(side(id), (Pair{0, -192})) << id;
  }
}

// The same centre: every cell on its own, at a query on which all is exact. |Q - P| = 3, e = 16, |N| = 12.
TYPED_TEST(RungsTest, EachCellHasTheSidesOfItsChoices) {
  const auto radius = [](std::string_view id) { return sides_at<TypeParam>(id, {1, -3, 0}, 2, edge_ab_radius); };
  const auto side = [](std::string_view id) { return sides_at<TypeParam>(id, {1, -3, 0}, 2, edge_ab_side_c); };
  for (const std::string frame : {"world", "centred"}) {
    EXPECT_EQ(radius("edges-" + frame + "-multiplied-rooted-6"), (Pair{3 * 16, 2 * 16})) << frame;
    EXPECT_EQ(radius("edges-" + frame + "-divided-rooted-4"), (Pair{3, 2})) << frame;
    EXPECT_EQ(radius("edges-" + frame + "-divided-squared-4"), (Pair{9, 4})) << frame;
    EXPECT_EQ(radius("edges-" + frame + "-multiplied-rooted-4"), (Pair{12, 2 * 4})) << frame;
    for (const char* rest : {"-divided-rooted-4", "-divided-squared-4", "-multiplied-rooted-4"}) {
      EXPECT_EQ(side("edges-" + frame + rest), (Pair{0, -192})) << frame << rest;
    }
  }
  EXPECT_EQ(radius("edges-world-multiplied-squared-4"), (Pair{9 * 16, 4 * 16}));
  EXPECT_EQ(radius("edges-centred-divided-rooted-6"), (Pair{3, 2}));
  EXPECT_EQ(radius("edges-centred-divided-squared-6"), (Pair{9, 4}));
  EXPECT_EQ(side("edges-centred-divided-squared-6"), (Pair{12, 0}));
  EXPECT_EQ(side("edges-world-multiplied-rooted-6"), (Pair{0, -12 * 256}));
  const auto plane = [](std::string_view id) { return sides_at<TypeParam>(id, {1, 1, 3}, 2, plane_radius); };
  EXPECT_EQ(plane("plane-divided-rooted"), (Pair{3, 2}));
  EXPECT_EQ(plane("plane-multiplied-rooted"), (Pair{3 * 16, 2 * 16}));
}

// Each slip changes the comparisons in which it occurs: QC = C e + Q and ac = B.B.
TYPED_TEST(RungsTest, TheSlipsChangeTheirOwnComparisonsOnly) {
  const Query<TypeParam> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, -3, 0}, 2};
  const auto published = sides_in(find_kernel("published"), q);
  const auto changed = [&](std::string_view id) {
    const auto found = sides_in(find_kernel(id), q);
    ComparisonBits bits = 0;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      if (found.lhs[k] != published.lhs[k] || found.rhs[k] != published.rhs[k]) bits |= one_bit<ComparisonBits>(k);
    }
    return bits;
  };
  const auto bit = [](Comparison c) { return one_bit<ComparisonBits>(c); };
  EXPECT_EQ(changed("first-publication"), bit(edge_ab_side_c) | bit(edge_bc_side_a) | bit(edge_ca_side_b));
  EXPECT_EQ(changed("vertex-typo"), bit(vertex_a_side_c) | bit(vertex_c_side_a));
  // A = (-1, 3, 0), B = (3, 3, 0), C = (-1, 7, 0): Q = (0, 48, 0), C e = (-16, 112, 0); B.B = 18.
  EXPECT_EQ(sides_at<TypeParam>("first-publication", {1, -3, 0}, 2, edge_ab_side_c), (Pair{48 * 160, 0}));
  EXPECT_EQ(sides_at<TypeParam>("vertex-typo", {1, -3, 0}, 2, vertex_a_side_c), (Pair{18, 10}));
}

// The centre lies inside the triangle. Edge AB runs at 45 degrees, and Q.QC overflows to inf - inf: `>=` does not hold,
// !(0 > NaN) does, and the packed form misses a contact at distance 0. All coordinates are finite.
TEST(PackedNonstrict, ANaNSideMissesAContact) {
  const float s = 0x1p26f;
  const Query<float> original{{-4 * s, -5 * s, 0}, {5 * s, 4 * s, 0}, {1 * s, 4 * s, 0}, {0, 0, 0}, 1};
  ASSERT_TRUE(is_valid(original));
  for_each_vertex_order(original, [](const Query<float>& q, std::string_view order) {
    EXPECT_EQ(answer(find_kernel("packed-nonstrict"), q).verdict, Verdict::separated) << order;
    EXPECT_EQ(answer(find_kernel("nonstrict"), q).verdict, Verdict::contact) << order;
    EXPECT_EQ(answer(find_kernel("reduced-nonstrict"), q).verdict, Verdict::contact) << order;
  });
  const auto sides = sides_in(find_kernel("packed-nonstrict"), original);
  EXPECT_TRUE(std::isnan(sides.lhs[edge_ab_side_c]));
}

}  // namespace
}  // namespace axiscert
