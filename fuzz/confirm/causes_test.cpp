// Kernels with one slip each are named by what the exact answers say; right ones are not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/cause.h"
#include "fuzz/confirm/classes.h"
#include "fuzz/confirm/wrong_kernels_testing.h"
#include "fuzz/queries/source.h"

namespace axiscert::causes {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// The cause on queries of these families; of all that have the kernel's entry, where none is named. Families of boxes
// take long.
std::optional<CauseRecord> cause(const Kernel& kernel, const std::vector<std::string>& names = {},
                                 Precision precision = Precision::binary32) {
  std::vector<SourcePtr> sources;
  for (const Family* family : families_of(*kernel.predicate, kernel.entry)) {
    if (names.empty() || std::ranges::find(names, family->name) != names.end())
      sources.push_back(family_source(*family));
  }
  std::vector<CauseSource> asked;
  for (const SourcePtr& source : sources)
    asked.push_back({{*source, 1, precision}, oracles_of(kernel).has_filters() ? 4096u : 512u});
  return cause_of(kernel, asked, "scalar");
}

// Recorded too, so that a reader of the test's output sees the sentences.
std::string sentence(const std::optional<CauseRecord>& found) {
  const std::string text = found ? found->sentence() : "none";
  std::cout << "  " << text << "\n";
  return text;
}

TEST(Causes, ARightKernelHasNone) {
  EXPECT_EQ(sentence(cause(sphere_kernel("right", Slip::none), {"general", "ratio", "far"})), "none");
  EXPECT_EQ(sentence(cause(box_kernel("right", 15))), "none");
  EXPECT_EQ(sentence(cause(box_triangle_kernel("right", 13))), "none");
}

TEST(Causes, AVertexThatIsForgottenIsNamed) {
  const auto found = cause(sphere_kernel("no-vertex-a", Slip::no_vertex_a));
  EXPECT_THAT(sentence(found), StartsWith("wrong on "));
  EXPECT_THAT(sentence(found), HasSubstr("nearest to vertex a"));
}

TEST(Causes, AnEdgeThatIsForgottenIsNamed) {
  const auto found = cause(sphere_kernel("no-edge-bc", Slip::no_edge_bc), {}, Precision::binary64);
  EXPECT_THAT(sentence(found), StartsWith("wrong on "));
  EXPECT_THAT(sentence(found), HasSubstr("nearest to edge bc"));
}

TEST(Causes, ATriangleWithAnObtuseCornerIsNamed) {
  const auto found = cause(sphere_kernel("first-edge", Slip::first_edge));
  EXPECT_THAT(sentence(found), StartsWith("wrong on "));
  EXPECT_THAT(sentence(found), HasSubstr("obtuse"));
}

TEST(Causes, ASlackBesideTheTriangleIsNamed) {
  const auto found = cause(sphere_kernel("slack", Slip::barycentric), {}, Precision::binary64);
  EXPECT_THAT(sentence(found), HasSubstr("0.1 % beside the triangle"));
}

TEST(Causes, OneSideIsNamed) {
  const auto found = cause(sphere_kernel("one-sided", Slip::one_sided));
  EXPECT_THAT(sentence(found), HasSubstr("spheres in contact with the centre behind"));
}

TEST(Causes, ALineInPlaceOfAnEdgeIsNamed) {
  EXPECT_THAT(sentence(cause(sphere_kernel("line-ca", Slip::line_ca))),
              HasSubstr("spheres in contact that do not meet the line of edge ca"));
}

TEST(Causes, WhatIsWrongOnExactQueriesAloneIsNamedAmongThese) {
  // It divides by the area; of triangles without one no query is clear.
  const auto found = cause(sphere_kernel("divides", Slip::none), {"general", "lattice"});
  EXPECT_THAT(sentence(found), HasSubstr("where arithmetic is exact, wrong on "));
  EXPECT_EQ(found->basis, CauseBasis::exact);
}

TEST(Causes, ABoxAndATriangleAreNamedByTheirSides) {
  EXPECT_THAT(sentence(cause(open_box_kernel())), HasSubstr("that meet the box made longer to lower z"));
  EXPECT_THAT(sentence(cause(one_sided_box_kernel())),
              HasSubstr("in contact with the box's centre behind the triangle"));
}

TEST(Causes, AQuaternionThatIsTakenForNoneIsNamed) {
  EXPECT_THAT(sentence(cause(still_box_kernel())), HasSubstr("with the vector part of a quaternion below 1e-3 of w"));
}

TEST(Causes, AnAxisThatIsLeftOutIsNamed) {
  EXPECT_THAT(sentence(cause(box_kernel("no-a1", 1))), HasSubstr("parted by a1 alone"));
  EXPECT_THAT(sentence(cause(box_kernel("no-a1b2", 11))), HasSubstr("parted by a1 x b2 alone"));
  EXPECT_THAT(sentence(cause(box_triangle_kernel("no-plane", 3))), HasSubstr("parted by the triangle's plane alone"));
  EXPECT_THAT(sentence(cause(box_triangle_kernel("no-y-ab", 7))), HasSubstr("parted by y x ab alone"));
}

TEST(Causes, ProductsOfParallelEdgesThatAreSkippedAreNamed) {
  EXPECT_THAT(sentence(cause(skipping_box_kernel())), HasSubstr("parted by one product of edges alone"));
}

TEST(Causes, MotionsAreNamedByHowTheyMove) {
  EXPECT_THAT(sentence(cause(stopping_kernel())), HasSubstr("in the last 5 %"));
  EXPECT_THAT(sentence(cause(one_way_kernel())), HasSubstr("motions in contact that move along the normal"));
  EXPECT_THAT(sentence(cause(parallel_kernel())), HasSubstr("parallel to the face"));
}

TEST(Causes, AllThatIsWrongIsNotExplainedByASmallClass) {
  // Wrong as a coin falls, by a number that no trait reads.
  const Kernel coin = wrong_kernel(sphere_triangle_predicate(), 0, "coin", []<class Real>(const Numbers<Real>& q) {
    const Query<double> wide = widened(query_from(q));
    const bool heads = std::fmod(std::abs(wide.a.x * 1e4 + wide.p.y * 1e3), 2) < 1;
    return heads ? Verdict::contact : Verdict::separated;
  });
  EXPECT_THAT(sentence(cause(coin, {"general"})), StartsWith("no class explains "));
}

TEST(Causes, TheWitnessIsWrongAndInTheClass) {
  const Kernel kernel = sphere_kernel("no-vertex-a", Slip::no_vertex_a);
  const auto found = cause(kernel);
  ASSERT_TRUE(found && found->witness);
  EXPECT_NE(found->witness->answered, found->witness->truth);
  EXPECT_EQ(found->witness->numbers.size(), 13u);
}

// The names of a query's traits, between blanks.
std::string traits_of(const Predicate& predicate, std::size_t entry, const std::vector<double>& given) {
  Numbers<double> numbers(given.size());
  std::ranges::copy(given, numbers.begin());
  const Traits& traits = *capabilities_of(predicate).traits;
  std::string text = " ";
  for (const std::string& name : trait_names(traits, traits.of(numbers, entry))) text += name + " ";
  return text;
}

TEST(Traits, OfASphereByTheLinesOfTheEdges) {
  const std::string found = traits_of(sphere_triangle_predicate(), 0, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1.9, 0.4, 0.1, 0.5});
  EXPECT_THAT(found, Not(HasSubstr(" off_ab ")));
  EXPECT_THAT(found, HasSubstr(" off_bc "));
  EXPECT_THAT(found, HasSubstr(" off_ca "));
}

// The box from -1 to 1 and a triangle.
std::string of_triangle(const std::vector<double>& corners) {
  std::vector<double> numbers = {0, 0, 0, 1, 1, 1};
  numbers.insert(numbers.end(), corners.begin(), corners.end());
  return traits_of(box_triangle_predicate(), 0, numbers);
}
TEST(Traits, OfABoxAndATriangleByWhatMeets) {
  const std::string pierced = of_triangle({-50, -50, 0, 50, -50, 0, 0, 80, 0});
  EXPECT_THAT(pierced, HasSubstr(" no_edge "));
  EXPECT_THAT(pierced, HasSubstr(" by_z "));
  EXPECT_THAT(pierced, Not(HasSubstr(" by_x ")));
  const std::string by_ab = of_triangle({-5, 0, 0, 5, 0, 0, 0, 9, 9});
  EXPECT_THAT(by_ab, HasSubstr(" by_ab "));
  EXPECT_THAT(by_ab, Not(HasSubstr(" no_edge ")));
  EXPECT_THAT(of_triangle({3, 0, 0, 3, 1, 0, 0, 0, 0}), HasSubstr(" reached_by_c "));
  EXPECT_THAT(of_triangle({-1, 5, 0, 1, 5, 0.5, 0, 0, 0}), HasSubstr(" beyond_ab "));
  EXPECT_THAT(of_triangle({-1, 5, 0, 1, 5, 0.5, 0, 0, 0}), Not(HasSubstr(" beyond_bc ")));
}
TEST(Traits, OfABoxAndATriangleBySides) {
  const std::string below = of_triangle({-0.5, -0.5, -3, 0.5, -0.5, -3, 0, 0.5, -3});
  EXPECT_THAT(below, HasSubstr(" below_z "));
  EXPECT_THAT(below, HasSubstr(" front "));
  EXPECT_THAT(below, HasSubstr(" level_edge "));
  for (const char* other : {" above_z ", " below_x ", " above_y ", " behind "})
    EXPECT_THAT(below, Not(HasSubstr(other)));
  EXPECT_THAT(of_triangle({0.5, -0.5, -3, -0.5, -0.5, -3, 0, 0.5, -3}), HasSubstr(" behind "));
  // Beyond an edge of the box it is beside no facet.
  EXPECT_THAT(of_triangle({3, 3, 0, 4, 3, 0, 3, 4, 0.5}), Not(HasSubstr("above_")));
}

TEST(Traits, OfTwoBoxesByTheAxisThatDecidesAndByEdges) {
  const auto boxes = [](double x, double half, double turn) {
    return traits_of(box_box_predicate(), 1,
                     {0, 0, 0, 1, 1, 1, 1, 0, 0, 0, x, 0, 0, half, half, half, 10, turn, 2 * turn, 3 * turn});
  };
  EXPECT_THAT(boxes(1.5, 0.5, 1), HasSubstr(" a0_decides "));
  EXPECT_THAT(boxes(1.75, 0.5, 1), HasSubstr(" a0_decides "));
  EXPECT_THAT(boxes(0, 0.25, 1), HasSubstr(" no_edge_of_a "));
  EXPECT_THAT(boxes(0, 4, 1), HasSubstr(" no_edge_of_b "));
  EXPECT_THAT(boxes(1, 1, 1), Not(HasSubstr(" no_edge_of_")));
  EXPECT_THAT(boxes(0, 1, 1e-3), HasSubstr(" tiny_turn "));
  EXPECT_THAT(boxes(0, 1, 1e-3), Not(HasSubstr(" tiniest_turn ")));
  EXPECT_THAT(boxes(0, 1, 1e-6), HasSubstr(" tiniest_turn "));
  EXPECT_THAT(boxes(0, 1, 0), Not(HasSubstr("_turn ")));
  EXPECT_THAT(boxes(0, 1, 0), HasSubstr(" perpendicular "));
}

TEST(Traits, OfAMotionByItsFirstContactAndItsWay) {
  // Down to a face at z = 0, from 10 with radius 1: it touches after 9 of the way.
  const auto motion = [](double way) {
    return traits_of(moving_sphere_predicate(), MovingSphere::entry,
                     {0, 0, 0, 9, 0, 0, 0, 9, 0, 1, 1, 10, 0, 0, -way, 1});
  };
  EXPECT_THAT(motion(9001), HasSubstr(" earliest "));
  EXPECT_THAT(motion(8999), Not(HasSubstr(" earliest ")));
  EXPECT_THAT(motion(0), HasSubstr(" parallel "));
  EXPECT_THAT(motion(20), Not(HasSubstr(" parallel ")));
}

// Wrong on all that have the traits 1, 2 and 4, of which 2 is narrow.
FoundClass class_of(std::size_t wrong, TraitSet traits, const TraitKinds& kinds) {
  std::vector<Case> cases(wrong, Case{traits | contact_trait, true});
  for (TraitSet part = 0; part < traits; ++part) {
    if ((part & ~traits) == 0) cases.insert(cases.end(), 8, Case{part | contact_trait, false});
  }
  return best_class(cases, {}, kinds);
}
TEST(BestClass, OfFewWrongCasesIsGeneral) {
  EXPECT_EQ(class_of(5, 7, {}).traits, TraitSet{7});
  EXPECT_EQ(std::popcount(class_of(4, 7, {}).traits & 7), 1);
  EXPECT_EQ(class_of(5, 3, {.narrow = 2}).traits, TraitSet{3});
  EXPECT_EQ(class_of(4, 3, {.narrow = 2}).traits & 2, TraitSet{0});
}

TEST(BestClass, ATraitThatStandsAloneHasNoOtherBesideIt) {
  EXPECT_EQ(class_of(8, 3, {.alone = 2}).traits & 3, TraitSet{1});
  EXPECT_EQ(class_of(8, 2, {.alone = 2}).traits & 3, TraitSet{2});
  std::vector<Case> cases(8, Case{3 | contact_trait, true});
  cases.insert(cases.end(), 9, Case{2 | contact_trait, false});
  cases.insert(cases.end(), 12, Case{1 | contact_trait, false});
  EXPECT_EQ(best_class(cases, {}, {.alone = 2}).traits & 3, TraitSet{1}) << "right on half of its queries";
  cases.erase(cases.begin() + 8);
  EXPECT_EQ(best_class(cases, {}, {.alone = 2}).traits & 3, TraitSet{2});
}

// Wrong on all of one trait and, by a coin, on others: half of the wrong verdicts have no trait but the exact answer.
TEST(BestClass, ASharpOneMayHaveAQuarterOfTheWrongVerdicts) {
  std::vector<Case> cases(10, Case{1 | separated_trait, true});
  cases.insert(cases.end(), 20, Case{contact_trait, true});
  cases.insert(cases.end(), 200, Case{contact_trait, false});
  cases.insert(cases.end(), 200, Case{separated_trait, false});
  EXPECT_EQ(best_class(cases, {}).traits, contact_trait);
  EXPECT_EQ(sharp_class(cases, {}).traits, TraitSet{1});
  cases.resize(30);
  cases.insert(cases.end(), 11, Case{contact_trait, true});
  cases.insert(cases.end(), 200, Case{contact_trait, false});
  EXPECT_EQ(sharp_class(cases, {}).traits, TraitSet{0}) << "less than a quarter";
}

TEST(BestClass, ItIsTheShortestWithoutAFault) {
  std::vector<Case> cases;
  for (TraitSet traits = 0; traits < 64; ++traits) cases.push_back({traits | contact_trait, (traits & 6) == 6});
  const FoundClass found = best_class(cases, {});
  EXPECT_EQ(found.traits, TraitSet{6});
  EXPECT_EQ(found.share, 1);
  EXPECT_EQ(found.rate, 1);
}

}  // namespace
}  // namespace axiscert::causes
