// The confirmed values of a query, compared with the formulae written out in GMP rationals.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/search/confirm.h"
#include "fuzz/search/method.h"
#include "fuzz/search/search.h"
#include "fuzz/sphere_triangle/search_evaluator.h"
#include "fuzz/sphere_triangle/search_ranges.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

constexpr std::uint64_t seed = 21;
using Vector = std::array<Rational, 3>;

Vector minus(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }
Rational dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
Vector cross(const Vector& u, const Vector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
Vector at(const Vector& u, const Rational& s, const Vector& v, const Rational& t) {
  return {u[0] * s + v[0] * t, u[1] * s + v[1] * t, u[2] * s + v[2] * t};
}

// l - r of plane.radius, vertex_a.radius, vertex_a.side_b, edge_ab.radius and edge_ab.side_c, as in the article.
std::array<std::pair<Comparison, Rational>, 5> margins(const Query<float>& q) {
  const auto vector = [](const Vec3<float>& v) { return Vector{exact(v.x), exact(v.y), exact(v.z)}; };
  const Vector p = vector(q.p), a = minus(vector(q.a), p), b = minus(vector(q.b), p), c = minus(vector(q.c), p);
  const Rational rr = exact(q.r) * exact(q.r);
  const Vector ab = minus(b, a), v = cross(ab, minus(c, a));
  const Rational d = dot(a, v), e = dot(v, v), e1 = dot(ab, ab), d1 = dot(a, b) - dot(a, a);
  const Vector q1 = at(a, e1, ab, -d1), qc = at(c, e1, q1, -1);
  using enum Comparison;
  return {{{plane_radius, d * d - rr * e},
           {vertex_a_radius, dot(a, a) - rr},
           {vertex_a_side_b, dot(a, b) - dot(a, a)},
           {edge_ab_radius, dot(q1, q1) - rr * e1 * e1},
           {edge_ab_side_c, dot(q1, qc)}}};
}

Query<float> settled(const char* family, std::uint64_t position) {
  Query<float> q = find_family(family).make<float>(seed, position);
  settle(q);
  return q;
}

TEST(Confirm, ErrorsAreThoseOfTheFormulaeInRationals) {
  const Kernel& kernel = find_kernel("published");
  Confirmer<float> confirmer(kernel, scalar_target);
  for (const char* family : {"general", "sliver", "far", "collinear"}) {
    for (std::uint64_t i = 0; i < 50; ++i) {
      const Query<float> q = settled(family, i);
      const Sides<float> computed = reference_sides(q);
      const auto found = confirmer.errors(q);
      ASSERT_TRUE(found);
      for (const auto& [which, margin] : margins(q)) {
        const Rational error = abs(exact(computed.lhs[which]) - exact(computed.rhs[which]) - margin) * (1 << 24);
        EXPECT_EQ(found->absolute[index_of(which)], round_up(error))
            << family << " " << i << " " << info(which).name << ", seed " << seed;
      }
    }
  }
}

TEST(Confirm, EveryPredicateHasErrorsOfTheSidesThatAKernelShows) {
  const Kernel& kernel = find_kernel("moving-sphere/twenty");
  Confirmer<float> confirmer(kernel, scalar_target);
  const auto exact_ones = confirmer.errors({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 1, 0, 0, 1});
  ASSERT_TRUE(exact_ones);
  ASSERT_EQ(exact_ones->absolute.size(), kernel.predicate->comparisons.size());
  for (const auto& error : exact_ones->absolute) EXPECT_TRUE(error && error->is_zero());
  const auto rounded = confirmer.errors(find_family("moving-sphere/general").make<float>(seed, 0));
  ASSERT_TRUE(rounded);
  EXPECT_TRUE(std::ranges::any_of(rounded->relative, [](const auto& error) { return error && !error->is_zero(); }));
  EXPECT_FALSE(confirmer.errors({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 1, 0, 0, -1})) << "no query";
}

TEST(Confirm, NothingBeyondTheBoxIsAnErrorOfIt) {
  Confirmer<float> confirmer(find_kernel("published"), scalar_target);
  Query<float> q{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, 1};
  EXPECT_TRUE(confirmer.value({Goal::error}, q));
  q.p.x = -0x1p-60f;  // 1 - p rounds to 1, and is more
  EXPECT_FALSE(confirmer.value({Goal::error}, q));
  q.p.x = 0;
  q.r = 1 + 0x1p-23f;
  EXPECT_FALSE(confirmer.value({Goal::error}, q));
  EXPECT_TRUE(confirmer.value({Goal::relative_error}, q)) << "which has no box";
}

// The guide may be arbitrarily wrong without harm to the reported values; but then it would guide badly.
TEST(Confirm, TheGuideIsNearTheTruth) {
  const Kernel& kernel = find_kernel("published");
  const auto near = [&]<class Real>(Real) {
    Evaluator<Real> evaluator(kernel, scalar_target);
    Confirmer<Real> confirmer(kernel, scalar_target);
    QueryBatch<Real> batch(64, coordinate_count);
    for (const char* family : {"general", "sliver", "needle"}) {
      for (std::uint64_t i = 0; i < 8; ++i) {
        Query<Real> q = find_family(family).make<Real>(seed, i);
        settle(q);
        batch.push_back(q);
      }
    }
    std::vector<double> scores;
    std::vector<Verdict> said;
    for (const Aim& aim : search_method_of(*kernel.predicate).aims(kernel, {})) {
      if (aim.goal == Goal::critical_radius) continue;  // estimated only to a fraction of an ulp
      QueryBatch<Real> solved = batch;
      evaluator.evaluate(aim, solved, scores, said);
      for (std::size_t i = 0; i < batch.size(); ++i) {
        if (scores[i] == 0) continue;
        const auto found = confirmer.value(aim, solved[i]);
        const bool tiny = !is_about_a_comparison(aim.goal) && scores[i] < 1e-6;  // within the estimate's own error
        ASSERT_TRUE(found || tiny) << name(aim, *kernel.predicate) << " " << i << ": " << scores[i];
        if (tiny) continue;
        EXPECT_NEAR(found->value(), scores[i], 1e-3 * scores[i])
            << name(aim, *kernel.predicate) << " " << i << ", seed " << seed;
      }
    }
  };
  near(0.0f);
  near(0.0);
}

TEST(Confirm, RangeIsLeftAtTheExponentsOfTheFormulae) {
  // |A|^2 = 3/4: 3/4 2^128 is finite in binary32, 3/4 2^130 is not. Downwards it becomes 0 in the end, as r^2 does
  // earlier.
  const Query<float> q{{0.5f, 0.5f, 0.5f}, {-0.5f, 0.5f, 0.25f}, {0.75f, -0.5f, 0.25f}, {0, 0, 0}, 0.5f};
  ASSERT_TRUE(has_good_shape(q));
  QueryBatch<float> one(1, coordinate_count);
  one.push_back(q);
  const auto implementation = find_kernel("published").on<float>(scalar_target);
  const Aim up{Goal::overflow, index_of(Comparison::vertex_a_radius)},
      down{Goal::underflow, index_of(Comparison::vertex_a_radius)};
  EXPECT_EQ(range_left(implementation, up, one).front(), 65);
  ASSERT_TRUE(range_left(implementation, down, one).front());
  const int least = *range_left(implementation, down, one).front();
  const auto holds = [&](int m) {
    return reference_sides(times_power(q, m)).lhs[1] > reference_sides(times_power(q, m)).rhs[1];
  };
  EXPECT_FALSE(holds(least));
  EXPECT_TRUE(holds(least + 1));
  EXPECT_LT(least, -70);
  EXPECT_EQ(
      range_exponent(Goal::underflow, Precision::binary32, range_score(Goal::underflow, Precision::binary32, least)),
      least);
}

TEST(Confirm, AShortEdgeIsNoGoodShape) {
  const Query<float> q{{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.501f}, {0.75f, -0.5f, 0.25f}, {0, 0, 0}, 0.5f};
  EXPECT_FALSE(has_good_shape(q));
}

}  // namespace

// Proved bounds compared with the errors that a search attains: a greater error would refute the proof or its
// interpretation.

namespace {

TEST(Proved, NowhereDoesASearchExceedIt) {
  for (const char* id : {"published", "reduced", "published+fma", "reduced+fma"}) {
    SearchPlan plan;
    plan.kernel = &find_kernel(id);
    for (std::size_t k = 0; k < comparison_count; ++k) plan.comparisons.push_back(k);
    for (const char* name : {"general", "sliver"}) plan.sources.push_back(family_source(find_family(name)));
    plan.evaluations = 1'000'000;
    plan.target = resolve_target("auto");
    const SearchResult result = search(plan, {}, false, [](const SearchProgress&) {});
    std::size_t errors = 0;
    for (const Find& find : result.finds) {
      if (find.aim.goal != Goal::error) continue;
      const auto proved = proved_error(*plan.kernel, plan.precision, find.aim.which);
      ASSERT_TRUE(proved) << id;
      EXPECT_LE(find.value, *proved) << id << " " << comparisons[find.aim.which].name;
      ++errors;
    }
    EXPECT_GT(errors, 0u) << id;
  }
}

// Other forms, and arithmetics that round differently, have other errors.
TEST(Proved, OnlyOfTheProgramsThatWereRecorded) {
  for (const char* id : {"reduced-along", "published+kahan", "ladder-0", "published+up"}) {
    EXPECT_FALSE(proved_error(find_kernel(id), Precision::binary32, index_of(Comparison::plane_radius))) << id;
  }
  EXPECT_EQ(proved_error(find_kernel("published"), Precision::binary64, index_of(Comparison::vertex_a_radius))->value(),
            8);
}

}  // namespace

}  // namespace axiscert
