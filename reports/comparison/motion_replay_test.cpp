// Known witnesses of motions, evaluated again: wrong verdicts, and times of contact.
#include <gmock/gmock.h>

#include <algorithm>

#include "fuzz/confirm/record.h"
#include "kernel/kernel.h"
#include "reports/comparison/replay.h"

namespace axiscert {
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
