// Kernels with one slip each are named by what the exact answers say; right ones are not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "exact/trait/oracles.h"
#include "fuzz/causes/cause.h"
#include "fuzz/causes/classes.h"
#include "fuzz/causes/wrong_kernels_testing.h"
#include "fuzz/queries/source.h"

namespace axiscert::causes {
namespace {

using testing::HasSubstr;
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

TEST(BestClass, ItIsTheShortestWithoutAFault) {
  std::vector<Case> cases;
  for (TraitSet traits = 0; traits < 16; ++traits) cases.push_back({traits | contact_trait, (traits & 6) == 6});
  const FoundClass found = best_class(cases, {});
  EXPECT_EQ(found.traits, TraitSet{6});
  EXPECT_EQ(found.share, 1);
  EXPECT_EQ(found.rate, 1);
}

}  // namespace
}  // namespace axiscert::causes
