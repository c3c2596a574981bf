// The search of the tests of boxes: axes stay rotations, the finds are deeper than the run from which it begins, and in
// each entry.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/boxes/cofactor_bound.h"
#include "exact/trait/examine.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/query_shape.h"
#include "fuzz/search/moves/moves.h"
#include "fuzz/search/search.h"

namespace axiscert {
namespace {

constexpr std::uint64_t boxes_seed = 11;

SearchPlan box_plan(const char* kernel, std::initializer_list<const char*> families, std::uint64_t evaluations) {
  SearchPlan plan;
  plan.kernel = &find_kernel(kernel);
  for (const char* name : families) plan.sources.push_back(family_source(find_family(name)));
  plan.first_sources = plan.sources;
  plan.first_queries = 30;
  plan.seed = boxes_seed;
  plan.evaluations = evaluations;
  plan.target = std::string(scalar_target);
  return plan;
}
SearchResult boxes_found(const SearchPlan& plan) {
  const std::atomic<bool> never = false;
  return search(plan, {}, never, [](const SearchProgress&) {});
}

double value_of(const SearchResult& result, Goal goal) {
  for (const Find& find : result.finds) {
    if (find.aim.goal == goal) return find.value.value();
  }
  return 0;
}

TEST(SearchBoxes, FramesAreThreeDirectionsOfOneBox) {
  const Predicate& boxes = find_predicate("box-box");
  EXPECT_EQ(shape_of(boxes.entries[0]).frames, (std::vector<std::size_t>{6, 21}));
  EXPECT_TRUE(shape_of(boxes.entries[1]).frames.empty());
  EXPECT_EQ(shape_of(find_predicate("box-triangle").entries[2]).frames, std::vector<std::size_t>{6});
  EXPECT_TRUE(shape_of(find_predicate("moving-sphere").entries[0]).frames.empty());
}

TEST(SearchBoxes, WhateverTheMovesMakeSettlesAsRotations) {
  for (const std::size_t entry : {0, 1}) {
    const QueryShape shape = shape_of(find_predicate("box-box").entries[entry]);
    Stream stream(boxes_seed, name_hash("box_search_predicate"), 1, Precision::binary32, entry);
    Dice random(stream);
    const Family& family = find_family(entry == 0 ? "box-box/resting" : "box-box/resting_turned");
    Numbers<float> q = family.make<float>(boxes_seed, 0);
    const Numbers<float> other = family.make<float>(boxes_seed, 1);
    for (int i = 0; i < 2000; ++i) {
      move(random, shape, q, other);
      settle(shape, q);
      ASSERT_TRUE(may_be_valid(shape, q)) << i << ", seed " << boxes_seed;
      for (const std::size_t first : shape.frames) ASSERT_TRUE(is_nearly_rotation(q, first)) << i;
    }
  }
}

TEST(SearchBoxes, TheTextbooksMissesAreDeepAndCofactorsWithinTheirBound) {
  const SearchResult textbook =
      boxes_found(box_plan("box-box/textbook", {"box-box/resting", "box-box/parallel"}, 2048));
  EXPECT_GT(value_of(textbook, Goal::missed_contact), 0.01);
  const SearchResult cofactor = boxes_found(box_plan("box-box/cofactor", {"box-box/stacked", "box-box/tangent"}, 2048));
  const double u = 0x1p-24;
  const boxes::CofactorBound bound = boxes::cofactor_bound(u, 8 * u);
  EXPECT_GT(value_of(cofactor, Goal::missed_contact), u);
  EXPECT_LT(value_of(cofactor, Goal::missed_contact), bound.missed);
  EXPECT_LT(value_of(cofactor, Goal::phantom_contact), bound.phantom);
}

TEST(SearchBoxes, AnEpsilonsBandIsFoundWide) {
  const SearchResult found = boxes_found(box_plan("box-box/gottschalk", {"box-box/crossed", "box-box/general"}, 2048));
  EXPECT_GT(value_of(found, Goal::phantom_contact), 2e-4);
}

TEST(SearchBoxes, EveryEntryIsServed) {
  for (const auto& [kernel, family] : {std::pair{"box-box/textbook-turned", "box-box/resting_turned"},
                                       std::pair{"box-triangle/textbook", "box-triangle/touching"},
                                       std::pair{"box-triangle/textbook-minmax", "box-triangle/voxel"},
                                       std::pair{"box-triangle/textbook-oriented", "box-triangle/touching_oriented"}}) {
    const SearchPlan plan = box_plan(kernel, {family}, 1024);
    const SearchResult result = boxes_found(plan);
    ASSERT_FALSE(result.finds.empty()) << kernel;
    Examiner examiner(*plan.kernel, plan.target);
    for (const Find& find : result.finds) {
      const Examination again = examiner.examine(std::get<Numbers<float>>(find.witness.numbers));
      EXPECT_TRUE(again.judgement.verdict_flip) << kernel << ' ' << query_line(find.witness);
      EXPECT_EQ(find.witness.entry, plan.kernel->entry);
    }
  }
}

}  // namespace
}  // namespace axiscert
