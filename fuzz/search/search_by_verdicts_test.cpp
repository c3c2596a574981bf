// The search in another predicate than the first: by the kernel's verdicts and the oracles' depth alone.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/boxes/cofactor_bound.h"
#include "exact/judge/examine.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/absolute_size.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/query_shape.h"
#include "fuzz/search/method.h"
#include "fuzz/search/moves.h"
#include "fuzz/search/search.h"

namespace axiscert {
namespace {

constexpr std::uint64_t motions_seed = 11;

SearchPlan motion_plan(const char* kernel, std::uint64_t evaluations) {
  SearchPlan plan;
  plan.kernel = &find_kernel(kernel);
  for (const char* name : {"moving-sphere/general", "moving-sphere/approach"})
    plan.sources.push_back(family_source(find_family(name)));
  plan.first_sources = plan.sources;
  plan.first_queries = 40;
  plan.seed = motions_seed;
  plan.evaluations = evaluations;
  plan.target = std::string(scalar_target);
  return plan;
}

SearchResult motions_found(const SearchPlan& plan, const std::optional<std::string>& state = {}) {
  const std::atomic<bool> never = false;
  return search(plan, state, never, [](const SearchProgress&) {});
}

// The deepest wrong verdict of the run from which the search begins.
double deepest_of_run(const SearchPlan& plan, FlipKind kind) {
  Examiner examiner(*plan.kernel, plan.target);
  double deepest = 0;
  for (const SourcePtr& source : plan.first_sources) {
    for (std::uint64_t n = 0; n < plan.first_queries; ++n) {
      const Examination found = examiner.examine(source->make<float>(plan.seed, n));
      if (found.judgement.verdict_flip == kind) deepest = std::max(deepest, *found.depth);
    }
  }
  return deepest;
}

TEST(SearchMotions, FindsDeeperFaultsThanTheRunFromWhichItBegins) {
  const SearchPlan plan = motion_plan("moving-sphere/rounded", 2048);
  const SearchResult result = motions_found(plan);
  ASSERT_EQ(result.aims, (std::vector<Aim>{{Goal::missed_contact}, {Goal::phantom_contact}}));
  ASSERT_EQ(result.finds.size(), 2u);
  for (const Find& find : result.finds) {
    const FlipKind kind = find.aim.goal == Goal::missed_contact ? FlipKind::false_separation : FlipKind::false_contact;
    Examiner examiner(*plan.kernel, plan.target);
    const Examination again = examiner.examine(std::get<Numbers<float>>(find.witness.numbers));
    EXPECT_EQ(again.judgement.verdict_flip, kind) << query_line(find.witness);
    EXPECT_NEAR(find.value.value(), *again.depth, 1e-5 * *again.depth);
    EXPECT_GE(find.value.value(), deepest_of_run(plan, kind)) << "seed " << motions_seed;
    // The run comes to 1.3e-5 of the scene.
    EXPECT_GT(find.value.value(), 1e-4) << query_line(find.witness);
  }
}

TEST(SearchMotions, WithoutAnIslandTheRunIsWhatItReports) {
  SearchPlan plan = motion_plan("moving-sphere/rounded", 0);
  plan.sources = {family_source(find_family("moving-sphere/lattice"))};
  const SearchResult result = motions_found(plan);
  for (const Find& find : result.finds) {
    EXPECT_GE(find.value.value(),
              deepest_of_run(
                  plan, find.aim.goal == Goal::missed_contact ? FlipKind::false_separation : FlipKind::false_contact));
  }
  EXPECT_GE(result.finds.size(), 1u);
}

TEST(SearchMotions, DoesNotDependOnThreadsOrWhereItStopped) {
  SearchPlan plan = motion_plan("moving-sphere/twenty", 4096);
  const SearchResult whole = motions_found(plan);
  plan.threads = 2;
  plan.evaluations = 2048;
  const SearchResult half = motions_found(plan);
  plan.evaluations = 4096;
  const SearchResult resumed = motions_found(plan, half.state);
  EXPECT_EQ(whole.finds, resumed.finds);
  EXPECT_EQ(whole.state, resumed.state);
}

// A kernel that says contact from half of the distance on: every query is wrong there.
TEST(SearchMotions, TheLengthIsSetToWhereTheVerdictChanges) {
  Kernel half = find_kernel("moving-sphere/twenty-nonstrict");
  half.formulae.clear();
  half.is_reference = false;
  half.exposes = Exposure::verdict;
  half.binary32 = [](std::string_view) {
    Implementation<float> doubled;
    const auto right = find_kernel("moving-sphere/twenty-nonstrict").on<float>(scalar_target);
    doubled.verdicts = [right](const QueryColumns<float>& batch, Verdict* out) {
      std::vector<float> lengths(batch.column[15], batch.column[15] + batch.size);
      for (float& r : lengths) r *= 2;
      QueryColumns<float> other = batch;
      other.column[15] = lengths.data();
      right.verdicts(other, out);
    };
    return doubled;
  };
  VerdictGuide<float> guide(half, scalar_target);
  QueryBatch<float> batch(1, 16);
  // Over the face at height 3.
  batch.push_back(Numbers<float>{0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3, 1, 0, 0, 0.25f});
  std::vector<double> scores;
  std::vector<Verdict> said;
  guide.evaluate({Goal::phantom_contact}, batch, scores, said);
  EXPECT_EQ(batch[0][15], 1.5f);
  EXPECT_NEAR(scores[0], 1.5 / std::sqrt(22.0), 1e-6) << "farthest from P is a corner of the prism, at (-2, 3, -3)";
  guide.evaluate({Goal::missed_contact}, batch, scores, said);
  EXPECT_EQ(batch[0][15], std::nextafter(1.5f, 0.0f));
  EXPECT_EQ(scores[0], 0);
}

// The queries are as a search has them.
TEST(SearchByVerdicts, RoughDepthsAreThoseOfTheOracles) {
  for (const char* name : {"moving-sphere", "box-box", "box-triangle"}) {
    const Predicate& predicate = find_predicate(name);
    const Quantities& quantities = *capabilities_of(predicate).quantities;
    for (std::size_t entry = 0; entry < predicate.entries.size(); ++entry) {
      const Oracles& oracles = oracles_of(predicate, entry);
      const QueryShape shape = shape_of(predicate.entries[entry]);
      for (const Family* family : families_of(predicate, entry)) {
        for (std::uint64_t n = 0; n < 12; ++n) {
          Numbers<float> q = family->make<float>(motions_seed, n);
          settle(shape, q);
          if (!may_be_valid(shape, q) || !oracles.is_valid(q)) continue;
          const double rough = quantities.rough_depth(entry, in_doubles(q)), depth = oracles.depth(q).value();
          const bool is_gap = !is_of_motions(predicate);
          const bool apart = oracles.truth(q).verdict == Verdict::separated;
          const double least = apart ? -depth : depth, most = !apart ? depth : is_gap ? 0 : -depth;
          EXPECT_GT(rough, least - 1e-12) << family->name << ' ' << n;
          EXPECT_LT(rough, most + 1e-12) << family->name << ' ' << n;
        }
      }
    }
  }
}

TEST(SearchMotions, WhateverTheMovesMakeSettles) {
  const QueryShape shape = shape_of(find_predicate("moving-sphere").entries.front());
  Stream stream(motions_seed, name_hash("moving_search_test"), 1, Precision::binary32, 0);
  Dice random(stream);
  for (const Family* family : families_of(find_predicate("moving-sphere"), 0)) {
    Numbers<float> q = family->make<float>(motions_seed, 0);
    const Numbers<float> other = family->make<float>(motions_seed, 1);
    for (int i = 0; i < 300; ++i) {
      move(random, shape, q, other);
      settle(shape, q);
      float greatest = 0;
      for (const float x : q) greatest = std::max(greatest, std::fabs(x));
      ASSERT_TRUE(may_be_valid(shape, q)) << family->name << ", move " << i << ", seed " << motions_seed;
      ASSERT_TRUE(greatest == 0 || (greatest >= 0.5f && greatest <= 256)) << family->name << ", move " << i;
    }
  }
}

}  // namespace

// The search in the predicates of boxes: axes stay rotations, the finds are deeper than the run from which it begins,
// and in each entry.

namespace {

constexpr std::uint64_t boxes_seed = 11;

SearchPlan box_plan(const char* kernel, std::initializer_list<const char*> families, std::uint64_t evaluations) {
  SearchPlan plan;
  plan.kernel = &find_kernel(kernel);
  for (const char* name : families) plan.sources.push_back(family_source(find_family(name)));
  plan.first_sources = plan.sources;
  plan.first_queries = 30;
  plan.what = {std::string(verdict_word)};
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
    Stream stream(boxes_seed, name_hash("box_search_test"), 1, Precision::binary32, entry);
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
