// The levels never-late and no-tunnel: times that a record says are late, missing or deep, and kernels of which nothing
// is known.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "fuzz/instruments/black_box.h"
#include "fuzz/moving_sphere/time_mutants.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

TEST(MotionLevels, NeverLateRefusesOneLateTime) {
  EXPECT_TRUE(unmet(motions(contacts(0, 0, 0.5)), "never-late").empty());
  const auto failures = unmet(motions(contacts(1, 1e-7, 0)), "never-late");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].text(),
            "<script> binary32 on tangent: times after the first contact, the latest by 2.5 ulps, 1.5e-07 of the way, "
            "length 0.25: 1 (witness late)");
  Json gross = contacts(1, 0.5, 0);
  gross["time"]["late_errors"]["largest_ulps"] = 1e44;
  gross["time"]["late_errors"]["largest_share"] = 0.125;
  EXPECT_EQ(unmet(motions(gross), "never-late")[0].what,
            "times after the first contact, the latest by 12.5 % of the way, length 0.25");
  const LevelOutcome met = outcomes_at(motions(contacts(0, 0, 0)), "never-late")[0];
  EXPECT_EQ(met.state, LevelState::met);
  EXPECT_THAT(met.covers, HasSubstr("1,800 contacts of"));
}

TEST(MotionLevels, NeverLateByALengthRefusesWhatIsFartherOnTheWay) {
  EXPECT_TRUE(unmet(motions(contacts(7, 0, 0)), "never-late=25cm").empty());
  EXPECT_EQ(unmet(motions(contacts(7, 0, 0)), "never-late=24.9cm")[0].text(),
            "<script> binary32 on tangent: times after the first contact, the latest by 25 cm of the way: 24.9 cm is "
            "allowed: 1");
  Json record = motions(contacts(7, 0, 0));
  record["plan"]["unit"] = "mm";
  EXPECT_TRUE(unmet(record, "never-late=1mm").empty());
  EXPECT_FALSE(unmet(record, "never-late=0.1mm").empty());
  EXPECT_THAT(sentence_of(parse_level("never-late=1mm")), HasSubstr("after the exact first contact by more than 1 mm"));
  for (const char* level : {"never-late=", "never-late=1", "never-late=0mm", "never-late=1 mile"})
    EXPECT_THROW(parse_level(level), Error) << level;
}

TEST(MotionLevels, NoTunnelRefusesWhatGoesInAsDeepAsItsNumber) {
  const auto refused = [](double late, double missed, const char* level) {
    return !unmet(motions(contacts(5, late, missed)), level).empty();
  };
  EXPECT_FALSE(refused(0.999999, 0.999999, "no-tunnel"));
  EXPECT_TRUE(refused(1, 0, "no-tunnel"));
  EXPECT_TRUE(refused(0, 1, "no-tunnel"));
  EXPECT_FALSE(refused(0.249999, 0.1, "no-tunnel=0.25"));
  EXPECT_TRUE(refused(0.25, 0, "no-tunnel=0.25"));
  EXPECT_TRUE(refused(0, 0.3, "no-tunnel=0.25"));
  const Failure through = unmet(motions(contacts(5, 1, 0)), "no-tunnel")[0];
  EXPECT_EQ(through.count, 3u);
  EXPECT_EQ(through.what,
            "late times with which the centre comes to the triangle; the latest is by 2.5 ulps, 1.5e-07 of the way, "
            "length 0.25");
  EXPECT_EQ(unmet(motions(contacts(5, 0, 0.5)), "no-tunnel=0.25")[0].what,
            "the deepest missed contact goes in by 0.5 of the radius, and less than 0.25 is allowed");
}

TEST(MotionLevels, AContactWithoutATimeMeetsNeither) {
  Json without = contacts(0, 0, 0);
  without["time"]["invalid"] = 2;
  for (const char* level : {"never-late", "never-late=1km", "no-tunnel"}) {
    const auto failures = unmet(motions(without), level);
    ASSERT_EQ(failures.size(), 1u) << level;
    EXPECT_EQ(failures[0].what, "contacts with a time outside [0, 1]");
    EXPECT_EQ(failures[0].count, 2u);
  }
}

TEST(MotionLevels, AKernelOrAPredicateWithoutTimesIsNotChecked) {
  Json silent = motions(contacts(0, 0, 1));
  silent["kernels"][0]["measures"] = Json::array();
  for (const char* level : {"never-late", "never-late=1mm", "no-tunnel", "no-tunnel=0.5"}) {
    const LevelOutcome outcome = outcomes_at(silent, level)[0];
    EXPECT_EQ(outcome.state, LevelState::not_checked) << level;
    EXPECT_EQ(outcome.reason, "the kernel gives no time of contact");
    EXPECT_THAT(outcomes_at(stored_record(), level)[0].reason, HasSubstr("sphere-triangle has no time of contact"));
  }
}

TEST(MotionLevels, ATunnelIsAShareOfTheRadius) {
  for (const char* level : {"no-tunnel=", "no-tunnel=0", "no-tunnel=1.5", "no-tunnel=-1", "no-tunnel=half",
                            "no-tunnel=0.12345678", "no-tunnel=nan"}) {
    try {
      unmet(motions(contacts(0, 0, 0)), level);
      ADD_FAILURE() << level;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("no-tunnel")) << level;
    }
  }
}

}  // namespace

// Faults of a time are each seen in a kernel that shows its verdict and its time alone; the right times pass
// (docs/mutation.md).

namespace {

constexpr std::uint64_t time_mutants_seed = 7, motions_each = 12;

// The counts of one kernel in the records of both precisions, over all families.
struct TimesSeen {
  std::uint64_t hits = 0, best = 0, early = 0, late = 0, untimed = 0, missed = 0, phantom = 0;
  std::vector<std::string> refused_by;

  void add(const Record& record, const KernelRecord& kernel) {
    for (const auto& [family, result] : kernel.families) {
      const TimeTally& time = *result.contacts->time;
      hits += result.contacts->answers;
      best += time.best;
      early += time.early;
      late += time.late;
      untimed += time.none + time.invalid;
      missed += result.verdict.false_separation;
      phantom += result.verdict.false_contact;
    }
    for (const char* level : {"logic", "never-late", "no-tunnel"}) {
      if (std::find(refused_by.begin(), refused_by.end(), level) != refused_by.end()) continue;
      for (const Failure& failure : unmet(record, level)) {
        if (failure.kernel != kernel.id) continue;
        refused_by.emplace_back(level);
        break;
      }
    }
  }
  // A time before the best is no fault of safety: no level asks about it, and the record counts it.
  bool is_caught() const { return !refused_by.empty() || early > 0; }
  std::string text(TimeFault fault) const {
    return fmt::format("{}: best {}, early {}, late {}, untimed {}, missed {}, phantom {}; refused by: {}; seed {}",
                       time_fault_texts[fault].name, best, early, late, untimed, missed, phantom,
                       fmt::join(refused_by, ", "), time_mutants_seed);
  }
};

EnumArray<TimeFault, TimesSeen> seen_of_all() {
  std::deque<Kernel> kernels;
  std::vector<const Kernel*> asked;
  for (const TimeFault fault : enumerators<TimeFault>) asked.push_back(&kernels.emplace_back(time_mutant(fault)));
  MutationPlan plan;
  plan.families = families_of(moving_sphere_predicate(), MovingSphere::entry);
  plan.seed = time_mutants_seed;
  EnumArray<TimeFault, TimesSeen> seen{};
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const Record record = record_of_kernels(plan, precision, motions_each, asked);
    for (const TimeFault fault : enumerators<TimeFault>) seen[fault].add(record, record.kernels[index_of(fault)]);
  }
  return seen;
}

// Long: the suites above plant each kind of fault alone, and this asks all families about all of them.
TEST(TimeMutantsLong, AreEachSeenByVerdictAndTimeAloneAndTheRightTimesPass) {
  const EnumArray<TimeFault, TimesSeen> seen = seen_of_all();
  const TimesSeen& right = seen[TimeFault::right];
  EXPECT_GT(right.hits, 200u);
  EXPECT_EQ(right.best, right.hits);
  EXPECT_EQ(right.missed + right.phantom, 0u);
  for (const TimeFault fault : enumerators<TimeFault>) {
    const bool is_right = fault == TimeFault::right;
    EXPECT_EQ(seen[fault].is_caught(), !is_right) << seen[fault].text(fault);
    EXPECT_EQ(seen[fault].refused_by.empty(), is_right || fault == TimeFault::early) << seen[fault].text(fault);
  }
}

}  // namespace

}  // namespace axiscert
