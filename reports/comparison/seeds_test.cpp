// How often compare calls a run worse: among runs that differ in chance alone, and among runs that do not.
#include <gtest/gtest.h>

#include "kernel/kernel.h"
#include "reports/comparison/compare.h"
#include "fuzz/confirm/record.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

struct Sample {
  std::vector<std::string> families;
  std::uint64_t trials;
  std::vector<Precision> precisions;
};

Record run(const Sample& sample, const std::string& kernel, std::uint64_t seed) {
  Plan plan;
  plan.questions.seed = seed;
  plan.answerers.kernels = {&find_kernel(kernel)};
  plan.questions.precisions = sample.precisions;
  for (const std::string& name : sample.families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.trials = [&](const Source&, Precision) { return sample.trials; };
  plan.running.target = std::string(scalar_target);
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  return record_of(plan, run_campaign(plan, never, [](const Progress&) {}), {});
}

// The record with its kernel renamed, as a new version of that other kernel would give it.
Record renamed(Record record, const std::string& id) {
  record.plan.kernels[0] = id;
  for (KernelRecord& kernel : record.kernels) kernel.id = id;
  for (WitnessRecord& witness : record.witnesses) witness.kernel = id;
  return record;
}

// Number of pairs of seeds 2i + 1 and 2i + 2 with an alarm.
int alarms(const Sample& sample, std::uint64_t pairs) {
  int found = 0;
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const Record before = run(sample, "published", 2 * i + 1), after = run(sample, "published", 2 * i + 2);
    const RunComparison comparison = compare_records(before, after, {});
    EXPECT_GT(comparison.tested, 0u);
    if (comparison.alarms() == 0) continue;
    ++found;
    std::printf("seeds %d and %d: %d alarms\n", static_cast<int>(2 * i + 1), static_cast<int>(2 * i + 2),
                static_cast<int>(comparison.alarms()));
  }
  return found;
}

// At most 5 % of 20 pairs: 1 pair.
TEST(CompareSeeds, TwentyPairsOfSeedsGiveAtMostOneAlarm) {
  EXPECT_LE(alarms({{"sliver", "repeated"}, 96, {Precision::binary32}}, 20), 1);
}

// The same test has to detect a real difference: strict sides invent contacts.
TEST(CompareSeeds, AnotherKernelIsSeenAcrossSeeds) {
  const Sample sample{{"repeated"}, 512, {Precision::binary32}};
  const Record before = run(sample, "nonstrict", 1), after = renamed(run(sample, "published", 2), "nonstrict");
  const RunComparison worse = compare_records(before, after, {}), better = compare_records(after, before, {});
  const auto phantoms = [](const RunComparison& comparison) {
    for (const ComparedCell& cell : comparison.cells) {
      if (cell.before.name() == "verdict.false_contact") return cell.change;
    }
    return Change::unchanged;
  };
  EXPECT_EQ(phantoms(worse), Change::worse);
  EXPECT_EQ(phantoms(better), Change::better);
}

TEST(CompareSeeds, KnownWitnessesOfTheSameKernelDoAsBefore) {
  const Record record = run({{"tangent", "repeated"}, 256, {Precision::binary32, Precision::binary64}}, "published", 1);
  const std::vector<ReplayedQuery> replayed = replay_witnesses(record, scalar_target);
  ASSERT_GT(replayed.size(), 20u);
  for (const ReplayedQuery& r : replayed) EXPECT_EQ(r.outcome, ReplayOutcome::as_before) << r.id << ": " << r.note;
}

TEST(CompareSeeds, KnownWitnessesOfAnotherKernelDoNot) {
  const Sample sample{{"repeated"}, 512, {Precision::binary32}};
  const auto count = [](const std::vector<ReplayedQuery>& all, ReplayOutcome outcome) {
    return std::count_if(all.begin(), all.end(), [&](const ReplayedQuery& r) { return r.outcome == outcome; });
  };
  // As if published had become nonstrict: phantom contacts are mended.
  const auto mended = replay_witnesses(renamed(run(sample, "published", 1), "nonstrict"), scalar_target);
  EXPECT_GT(count(mended, ReplayOutcome::mended), 0);
  const auto absent = replay_witnesses(renamed(run(sample, "published", 1), "nosuch"), scalar_target);
  EXPECT_EQ(count(absent, ReplayOutcome::not_replayed), static_cast<std::ptrdiff_t>(absent.size()));
  EXPECT_NE(absent.at(0).note, "");
}

// The file does not exist: the note of a replay that tried to load it says so.
TEST(CompareSeeds, APluginThatARecordNamesIsLoadedForWhoNamesItAlone) {
  const std::string id = "plugin:/no such.so";
  const Record record = renamed(run({{"repeated"}, 64, {Precision::binary32}}, "published", 1), id);
  const auto untrusted = replay_witnesses(record, scalar_target);
  const auto trusted = replay_witnesses(record, scalar_target, {{id, id}});
  ASSERT_FALSE(untrusted.empty());
  EXPECT_EQ(untrusted[0].note, "a plug-in that a record names is loaded only with --kernel 'plugin:/no such.so'");
  EXPECT_NE(trusted[0].note.find("there is no file /no such.so"), std::string::npos) << trusted[0].note;
}

TEST(CompareSeedsLong, AHundredPairsOfSeedsGiveAtMostFiveAlarms) {
  Sample sample{{}, 512, {Precision::binary32, Precision::binary64}};
  for (const Family* family : families_of(sphere_triangle_predicate())) sample.families.emplace_back(family->name);
  EXPECT_LE(alarms(sample, 100 / TRIAL_DIVISOR), 5);
}

}  // namespace
}  // namespace axiscert
