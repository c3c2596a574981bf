// never-late and no-tunnel: times that a record says are late, missing or deep, and kernels of which nothing is known.
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/motion_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

TEST(MotionLevels, NeverLateRefusesOneLateTime) {
  EXPECT_TRUE(unmet(motions(contacts(0, 0, 0.5)), "never-late").empty());
  const auto failures = unmet(motions(contacts(1, 1e-7, 0)), "never-late");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].text(),
            "<script> binary32 on tangent: times after the first contact, the latest by 2.5 u of the displacement: 1 "
            "(witness late)");
  const LevelOutcome met = outcomes_at(motions(contacts(0, 0, 0)), "never-late")[0];
  EXPECT_EQ(met.state, LevelState::met);
  EXPECT_THAT(met.covers, HasSubstr("1,800 contacts of"));
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
  EXPECT_EQ(through.what, "late times with which the centre comes to the triangle");
  EXPECT_EQ(unmet(motions(contacts(5, 0, 0.5)), "no-tunnel=0.25")[0].what,
            "the deepest missed contact goes in by 0.5 of the radius, and less than 0.25 is allowed");
}

TEST(MotionLevels, AContactWithoutATimeMeetsNeither) {
  Json without = contacts(0, 0, 0);
  without["time"]["invalid"] = 2;
  for (const char* level : {"never-late", "no-tunnel"}) {
    const auto failures = unmet(motions(without), level);
    ASSERT_EQ(failures.size(), 1u) << level;
    EXPECT_EQ(failures[0].what, "contacts with a time outside [0, 1]");
    EXPECT_EQ(failures[0].count, 2u);
  }
}

TEST(MotionLevels, AKernelOrAPredicateWithoutTimesIsNotChecked) {
  Json silent = motions(contacts(0, 0, 1));
  silent["kernels"][0]["measures"] = Json::array();
  for (const char* level : {"never-late", "no-tunnel", "no-tunnel=0.5"}) {
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
}  // namespace axiscert
