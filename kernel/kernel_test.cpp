// The formulae against hand computations, the vocabulary, the registry and the self-check.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "kernel/sphere_triangle/forms/contracted.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/registry/self_check.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
Query<Real> unit_right_triangle(Vec3<Real> p, Real r) {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, p, r};
}

TEST(Names, BitsAreInTheOrderOfTheTable) {
  EXPECT_EQ(comparisons[0].name, "plane.radius");
  EXPECT_EQ(comparisons[15].name, "edge_ca.side_b");
  EXPECT_EQ(comparisons_of(Axis::vertex_b), 0b1110000);
  EXPECT_EQ(axes_of(0b1), 0b1);
  EXPECT_EQ(axes_of(0b1110), 0b10);
  EXPECT_EQ(axes_of(0b0110), 0);
  EXPECT_EQ(std::popcount(side_comparisons), 9);
}

// Centre (1/4, 1/4, 2): A = (-1/4, -1/4, -2), and so on; every side is a small dyadic number, computed by hand.
TEST(Formulae, AgreeWithAHandComputation) {
  const auto sides = reference_sides(unit_right_triangle<float>({0.25f, 0.25f, 2}, 1));
  const auto at = [&](Comparison c) { return std::pair{sides.lhs[c], sides.rhs[c]}; };
  using enum Comparison;
  EXPECT_EQ(at(plane_radius), std::pair(4.f, 1.f));           // V = (0, 0, 1), d = -2
  EXPECT_EQ(at(vertex_a_radius), std::pair(4.125f, 1.f));     // 1/16 + 1/16 + 4
  EXPECT_EQ(at(vertex_a_side_b), std::pair(3.875f, 4.125f));  // -3/16 + 1/16 + 4
  EXPECT_EQ(at(vertex_b_radius), std::pair(4.625f, 1.f));     // 9/16 + 1/16 + 4
  EXPECT_EQ(at(vertex_b_side_c), std::pair(3.625f, 4.625f));  // -3/16 - 3/16 + 4
  EXPECT_EQ(at(edge_ab_radius), std::pair(4.0625f, 1.f));     // Q1 = (0, -1/4, -2)
  EXPECT_EQ(at(edge_ab_side_c), std::pair(-0.25f, 0.f));      // QC = C - Q1 = (-1/4, 1, 0)
  EXPECT_EQ(at(edge_bc_radius), std::pair(16.5f, 4.f));       // e = 2, distance^2 to the line 4 + 1/8, times e^2
}

TEST(Formulae, TheArticlesAxesDecideTheirRegions) {
  const auto separating = [](Vec3<double> p, double r) {
    return axes_of(bits_of(reference_sides(unit_right_triangle<double>(p, r)), Strictness::strict));
  };
  const auto bit = [](Axis a) { return one_bit<AxisBits>(a); };
  EXPECT_TRUE(separating({0.25, 0.25, 2}, 1) & bit(Axis::plane));
  EXPECT_TRUE(separating({-2, -2, 0}, 1) & bit(Axis::vertex_a));
  EXPECT_TRUE(separating({4, 0, 0}, 1) & bit(Axis::vertex_b));
  EXPECT_TRUE(separating({0, 4, 0}, 1) & bit(Axis::vertex_c));
  EXPECT_TRUE(separating({0.5, -2, 0}, 1) & bit(Axis::edge_ab));
  EXPECT_TRUE(separating({2, 2, 0}, 1) & bit(Axis::edge_bc));
  EXPECT_TRUE(separating({-2, 0.5, 0}, 1) & bit(Axis::edge_ca));
  EXPECT_EQ(separating({0.25, 0.25, 0.5}, 1), 0u);
  EXPECT_EQ(separating({0.25, 0.25, 0.5}, 0.5), 0u) << "touching is contact";
}

// The specification fault of the strict test in its smallest form (A = B): separated by 1, reported as a contact.
TEST(Formulae, StrictSidesInventAContactOnARepeatedVertex) {
  const Query<double> q{{2, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, 1};
  const auto sides = reference_sides(q);
  EXPECT_EQ(verdict_of(axes_of(bits_of(sides, Strictness::strict))), Verdict::contact);
  EXPECT_EQ(verdict_of(axes_of(bits_of(sides, Strictness::nonstrict))), Verdict::separated);
}

TEST(Registry, ListsEveryKernelOnceAndNamesThemForAnUnknownOne) {
  for (const Kernel& kernel : kernels()) EXPECT_EQ(&find_kernel(kernel.id), &kernel);
  try {
    find_kernel("publishd");
    FAIL() << "an unknown kernel was found";
  } catch (const Error& e) {
    EXPECT_EQ(std::string(e.what()).find("unknown kernel 'publishd'; did you mean 'published'? plugin:PATH.so or "
                                         "program:MANIFEST.json is one of your own; the nearest of "),
              0u);
  }
}

// Queries of which the filters leave some open, and that every kernel of this predicate takes.
TEST(Registry, AKernelThatDeclinesSaysThatItMayAndAnyThatSaysSoDeclines) {
  std::mt19937_64 random(5);
  QueryBatch<float> queries(4000, coordinate_count);
  for (std::size_t i = 0; i < 4000; ++i) {
    queries.push_back(i % 2 == 0 ? testing_support::coarse_query_of_any_size<float>(random)
                                 : testing_support::random_query<float>(random, i % 4 == 1));
  }
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate != &sphere_triangle_predicate() || !kernel.has(Precision::binary32)) continue;
    std::vector<Verdict> verdicts(queries.size());
    kernel.on<float>(scalar_target).verdicts(queries.columns(), verdicts.data());
    EXPECT_EQ(std::count(verdicts.begin(), verdicts.end(), Verdict::undecided) != 0, kernel.may_decline) << kernel.id;
  }
}

// Whatever formulae there are, a kernel is judged by them.
TEST(Registry, EverySetOfFormulaeIsAKernels) {
  std::set<Formulae> claimed;
  for (const Kernel& kernel : kernels()) claimed.insert(formulae_of(kernel));
  for (std::size_t i = 0; i < formulae_count; ++i) {
    const auto formulae = static_cast<Formulae>(i);
    EXPECT_TRUE(claimed.contains(formulae)) << "kernel/formulae_list.h has '" << name(formulae)
                                            << "', of which kernel/sphere_triangle/kernels.cpp has no kernel";
  }
}

TEST(Registry, ResolvesTargetsInAnyCaseAndNamesThemForAnUnknownOne) {
  EXPECT_EQ(resolve_target("auto"), available_targets().front());
  EXPECT_EQ(resolve_target("SCALAR"), "scalar");
  try {
    resolve_target("MMX");
    FAIL() << "an unknown target was found";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("target 'MMX' is not on this machine; targets: auto, "), std::string::npos);
  }
}

TEST(SelfCheck, AcceptsEveryKernelOnEveryTarget) {
  for (const std::string& target : available_targets()) EXPECT_NO_THROW(require_uncontracted(target)) << target;
}

TEST(SelfCheck, RefusesAContractedKernel) {
  Kernel contracted;
  contracted.id = "contracted";
  contracted.predicate = &sphere_triangle_predicate();
  contracted.formulae = "published";
  contracted.binary64 = [](std::string_view) { return Implementation<double>{{}, contracted_explain<double>}; };
  const auto wrong = self_check<double>(contracted, "scalar");
  ASSERT_TRUE(wrong.has_value());
  EXPECT_NE(wrong->find("-ffp-contract=off"), std::string::npos) << *wrong;
}

}  // namespace
}  // namespace axiscert
