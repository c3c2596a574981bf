// The level no-slack: sizes with and without a unit, what was found, and what could not be seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

// A record whose kernels have a slack of a part of r, of this size, on scenes on which one of `least` would be seen.
Json with_slack(double size, double least) {
  Json record = stored_record();
  const Json look = {{"where", "nearest to an edge"}, {"bracketed", 108},        {"least_relative", least},
                     {"least_absolute", least},       {"off_relative", nullptr}, {"off_absolute", nullptr}};
  Json found = Json::array();
  if (size > 0) {
    found.push_back({{"kind", "relative"},
                     {"to", "r"},
                     {"side", "early"},
                     {"size", size},
                     {"least", size},
                     {"greatest", size},
                     {"in_units", 2 * size},
                     {"shown", 61},
                     {"looked_at", 64},
                     {"where", "nearest to an edge"},
                     {"witness", Json::object()},
                     {"said", "contact"}});
  }
  for (Json& kernel : record["kernels"])
    kernel["slack"] = {{"asked", 110},    {"bracketed", 108},       {"answers", 6000},
                       {"looks", {look}}, {"blind", Json::array()}, {"found", found}};
  return record;
}
const LevelOutcome& first(const std::vector<LevelOutcome>& outcomes) { return outcomes.front(); }

TEST(SlackLevel, ASlackAboveTheSizeFailsWithItsSizeAndQueries) {
  const auto failures = first(outcomes_at(with_slack(1e-3, 1e-5), "no-slack=1e-4")).failures;
  ASSERT_FALSE(failures.empty());
  EXPECT_THAT(failures.back().text(),
              HasSubstr("contact comes too early by 0.001 of r on 61 of 64 queries nearest to an edge"));
  EXPECT_TRUE(first(outcomes_at(with_slack(1e-3, 1e-5), "no-slack=1e-2")).failures.empty());
}

TEST(SlackLevel, ASizeWithAUnitIsALength) {
  EXPECT_FALSE(first(outcomes_at(with_slack(1e-3, 1e-5), "no-slack=1mm")).failures.empty());
  EXPECT_TRUE(first(outcomes_at(with_slack(4e-4, 1e-5), "no-slack=1mm")).failures.empty());
  EXPECT_TRUE(first(outcomes_at(with_slack(1e-3, 1e-5), "no-slack=1in")).failures.empty());
}

TEST(SlackLevel, WhatCouldNotBeSeenIsNotChecked) {
  const LevelOutcome blind = first(outcomes_at(with_slack(0, 1e-3), "no-slack=1e-4"));
  EXPECT_EQ(blind.state, LevelState::not_checked);
  EXPECT_THAT(blind.reason, HasSubstr("the least slack that would be seen is 0.001 of a length"));
  // One kind that is too coarse is enough, for a slack may be in one branch alone.
  Json uneven = with_slack(0, 1e-5);
  for (Json& kernel : uneven["kernels"]) {
    Json coarse = kernel["slack"]["looks"][0];
    coarse["where"] = "beside edge bc";
    coarse["least_relative"] = 4e-3;
    kernel["slack"]["looks"].push_back(coarse);
  }
  const LevelOutcome in_part = first(outcomes_at(uneven, "no-slack=1e-4"));
  EXPECT_EQ(in_part.state, LevelState::not_checked);
  EXPECT_THAT(in_part.reason, HasSubstr("0.004 of a length on queries beside edge bc"));
  EXPECT_NE(first(outcomes_at(uneven, "no-slack=5e-3")).state, LevelState::not_checked);
  Json none = stored_record();
  for (Json& kernel : none["kernels"]) kernel["slack"] = nullptr;
  const LevelOutcome unknown = first(outcomes_at(none, "no-slack=1e-4"));
  EXPECT_EQ(unknown.state, LevelState::not_checked);
  EXPECT_THAT(unknown.reason, HasSubstr("slacks were not looked for"));
}

TEST(SlackLevel, AnswersThatAreOffByNoOneSizeFail) {
  Json record = with_slack(0, 1e-5);
  for (Json& kernel : record["kernels"]) kernel["slack"]["looks"][0]["off_relative"] = 0.08;
  const LevelOutcome outcome = first(outcomes_at(record, "no-slack=1e-2"));
  EXPECT_EQ(outcome.state, LevelState::not_met);
  EXPECT_THAT(outcome.failures.back().text(), HasSubstr("24 or more of 108 queries nearest to an edge turn off the "
                                                        "exact turn by 0.08 of a length or more"));
  EXPECT_TRUE(first(outcomes_at(record, "no-slack=0.1")).failures.empty());
}

TEST(SlackLevel, AKindWithoutATurnIsNotChecked) {
  Json record = with_slack(0, 1e-5);
  for (Json& kernel : record["kernels"]) kernel["slack"]["blind"] = {"nearest to a vertex"};
  const LevelOutcome outcome = first(outcomes_at(record, "no-slack=1e-2"));
  EXPECT_EQ(outcome.state, LevelState::not_checked);
  EXPECT_THAT(outcome.reason, HasSubstr("the answer turns on fewer than 32 of the queries nearest to a vertex"));
}

TEST(SlackLevel, ASizeHasToBeALengthOrAPart) {
  for (const char* level : {"no-slack=0", "no-slack=-1", "no-slack=1parsec", "no-slack=mm", "no-slack="})
    EXPECT_THROW(parse_level(level), Error) << level;
}

}  // namespace
}  // namespace axiscert
