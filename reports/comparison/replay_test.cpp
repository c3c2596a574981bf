// Known witnesses, evaluated again: of a kernel that promises or answers less neither is mended; of motions, wrong
// verdicts and times of contact.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "kernel/kernel.h"
#include "reports/comparison/replay.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Not;

Record recorded_by(const std::string& kernel, std::initializer_list<const char*> families, std::uint64_t trials = 256) {
  Plan plan;
  plan.questions.seed = 3;
  plan.answerers.kernels = {&find_kernel(kernel)};
  plan.questions.precisions = {Precision::binary32};
  for (const char* name : families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.trials = [=](const Source&, Precision) { return trials; };
  plan.running.target = std::string(scalar_target);
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  return record_of(plan, run_campaign(plan, never, [](const Progress&) {}), {});
}

std::string promises(const char* kind) { return fmt::format("plugin:{}/promises/{}.so", BUILD_FOLDER, kind); }

// The witnesses of the record, as though this kind of kernel/plugin/promises_testing.c had given them.
std::vector<ReplayedQuery> replayed_by(Record record, const char* kind) {
  const std::string id = promises(kind);
  record.plan.kernels[0] = id;
  for (KernelRecord& kernel : record.kernels) kernel.id = id;
  for (WitnessRecord& witness : record.witnesses) witness.kernel = id;
  return replay_witnesses(record, scalar_target, {{id, id}});
}

std::set<std::string> outcomes(const std::vector<ReplayedQuery>& all) {
  std::set<std::string> names;
  for (const ReplayedQuery& r : all) names.emplace(replay_names[r.outcome]);
  return names;
}

// Phantom contacts, and a kernel that is right about them, is not any more to answer them, or does not answer them.
TEST(ReplayPromises, OnlyARightVerdictIsMended) {
  const Record wrong = recorded_by(promises("always_contact"), {"general", "far"});
  ASSERT_GT(wrong.witnesses.size(), 3u);
  EXPECT_THAT(outcomes(replayed_by(wrong, "always_contact")), ElementsAre("as before"));
  EXPECT_THAT(outcomes(replayed_by(wrong, "keeps_its_promise")), ElementsAre("mended"));
  for (const char* kind : {"declines_separations", "answers_77"}) {
    const auto none = replayed_by(wrong, kind);
    EXPECT_THAT(outcomes(none), ElementsAre("no verdict now")) << kind;
    EXPECT_FALSE(none[0].is_alarm()) << kind;
  }
  EXPECT_EQ(replayed_by(wrong, "declines_separations")[0].note, "undecided");
}

TEST(ReplayPromises, WhatIsNotPromisedAnyMoreIsNotMended) {
  const Record wrong = recorded_by(promises("always_contact"), {"general", "far"});
  const auto limited = replayed_by(wrong, "limited_to_nothing"), gone = replayed_by(wrong, "binary64_alone");
  for (const auto& all : {limited, gone}) {
    EXPECT_THAT(outcomes(all), ElementsAre("no longer promised"));
    EXPECT_TRUE(all[0].is_alarm());
  }
  EXPECT_EQ(limited[0].note, "radius from 1e+300, was none");
  EXPECT_EQ(gone[0].note, "it does not exist in binary32 here");
  // A query that was not promised in OLD either has not been lost.
  Record never = wrong;
  for (KernelRecord& kernel : never.kernels) kernel.limits.emplace().least_radius = 1e300;
  EXPECT_THAT(outcomes(replayed_by(never, "limited_to_nothing")), Not(Contains("no longer promised")));
}

// Witnesses of comparisons under right verdicts: no answer is wrong now, unless the kernel may decline.
TEST(ReplayPromises, NoAnswerWhereTheVerdictWasRightIsWrongNow) {
  Record right = recorded_by("published", {"tangent"});
  std::erase_if(right.witnesses, [](const WitnessRecord& witness) {
    return witness.truth != witness.computed || witness.truth != Verdict::contact;
  });
  ASSERT_GT(right.witnesses.size(), 0u);
  EXPECT_THAT(outcomes(replayed_by(right, "answers_77")), ElementsAre("wrong now"));
  EXPECT_THAT(outcomes(replayed_by(right, "declines_contacts")), ElementsAre("no verdict now")) << "it declares that";
}

// A kernel without a promise of touching queries is not held to those that it was held to.
TEST(ReplayPromises, TouchingQueriesThatAreEitherNowAreNotMended) {
  Record record = recorded_by("published", {"lattice"});
  KernelRecord& kernel = record.kernels[0];
  const Json witness =
      Json::parse(R"({"id": "touching", "precision": "binary32", "family": "lattice", "kernel": "published",
    "address": "1:lattice:1:binary32:0:1", "depth": 0, "exact_comparisons": null, "computed_comparisons": null,
    "shows": [], "sides": null,
    "a": ["0x1p+0", "0x0p+0", "0x0p+0"], "b": ["0x1p+1", "0x0p+0", "0x0p+0"], "c": ["0x1p+1", "0x1p+0", "0x0p+0"],
    "p": ["0x0p+0", "0x0p+0", "0x0p+0"], "r": "0x1p+0", "truth": "contact", "computed": "separated", "touching": true,
    "flips": [{"level": "verdict", "name": "verdict", "kind": "false_separation", "decisive": true, "links": ["rounding"]}]})");
  record.witnesses = {read_as<WitnessRecord>(witness)};
  const std::string either = fmt::format("plugin:{}/declarations/all_but_last.so", BUILD_FOLDER);
  kernel.id = record.witnesses[0].kernel = record.plan.kernels[0] = either;
  const auto replayed = [&] { return replay_witnesses(record, scalar_target, {{either, either}}); };
  const auto now = replayed();
  EXPECT_THAT(outcomes(now), ElementsAre("no longer promised"));
  EXPECT_THAT(now[0].note, testing::HasSubstr("touching either, was contact"));
  kernel.touching = TouchingPolicy::either;
  EXPECT_THAT(outcomes(replayed()), Not(Contains("no longer promised")));
}

}  // namespace

// Known witnesses of motions, evaluated again: wrong verdicts, and times of contact.

namespace {

constexpr std::uint64_t replay_seed = 3;

Record record_of_motions(const char* kernel, std::initializer_list<const char*> families) {
  Plan plan;
  plan.questions.seed = replay_seed;
  plan.answerers.kernels = {&find_kernel(kernel)};
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  for (const char* name : families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.trials = [](const Source&, Precision) { return std::uint64_t{120}; };
  plan.running.target = std::string(scalar_target);
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  return record_of(plan, run_campaign(plan, never, [](const Progress&) {}), {});
}

// The record as though another kernel had given it.
Record as_of(Record record, const char* kernel) {
  for (WitnessRecord& witness : record.witnesses) witness.kernel = kernel;
  return record;
}

std::ptrdiff_t count_of(const std::vector<ReplayedQuery>& all, ReplayOutcome outcome) {
  return std::count_if(all.begin(), all.end(), [&](const ReplayedQuery& r) { return r.outcome == outcome; });
}

TEST(ReplayMotions, TheSameKernelDoesAsBefore) {
  const Record rounded = record_of_motions("moving-sphere/rounded", {"moving-sphere/approach", "moving-sphere/graze"}),
               ends = record_of_motions("moving-sphere/ends-gated", {"moving-sphere/ends_approach"});
  for (const Record& record : {rounded, ends}) {
    const std::vector<ReplayedQuery> all = replay_witnesses(record, scalar_target);
    ASSERT_GT(all.size(), 3u) << "seed " << replay_seed;
    for (const ReplayedQuery& r : all) EXPECT_EQ(r.outcome, ReplayOutcome::as_before) << r.id << ": " << r.note;
  }
}

TEST(ReplayMotions, AnotherKernelMendsVerdictsOrIsLate) {
  // Phantoms of the strict sides are mended by the others.
  const Record strict = record_of_motions("moving-sphere/twenty", {"moving-sphere/line_sweep"});
  const auto mended = replay_witnesses(as_of(strict, "moving-sphere/twenty-nonstrict"), scalar_target);
  EXPECT_GT(count_of(mended, ReplayOutcome::mended), 0) << "seed " << replay_seed;
  // Witnesses of the best times that there are; the other kernel is late on some of them.
  const Record best = record_of_motions("moving-sphere/gated", {"moving-sphere/general"});
  Record early = as_of(best, "moving-sphere/rounded");
  for (WitnessRecord& witness : early.witnesses) {
    if (witness.measures && *witness.measures) (*witness.measures)->time = TimeVerdict::early;
  }
  const auto late = replay_witnesses(early, scalar_target);
  EXPECT_GT(count_of(late, ReplayOutcome::wrong_now), 0) << "seed " << replay_seed;
  const auto first = std::find_if(late.begin(), late.end(), [](const ReplayedQuery& r) { return r.is_alarm(); });
  EXPECT_THAT(first->note, testing::HasSubstr("time late"));
}

TEST(ReplayMotions, AKernelOfAnotherEntryIsNotAskedAndPromisesItNoMore) {
  const Record record = record_of_motions("moving-sphere/rounded", {"moving-sphere/approach"});
  for (const ReplayedQuery& r : replay_witnesses(as_of(record, "moving-sphere/ends-rounded"), scalar_target)) {
    EXPECT_EQ(r.outcome, ReplayOutcome::not_promised);
    EXPECT_EQ(r.note, "it takes the entry endpoints of the predicate moving-sphere here");
  }
}

}  // namespace

}  // namespace axiscert
