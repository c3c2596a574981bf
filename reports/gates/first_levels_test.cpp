// The levels with which a report begins: those that were required, else those that are advised.
#include "fuzz/text/json_form.h"
#include "reports/gates/requirement.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(FirstLevels, AreThoseThatWereRequired) {
  const Record record = read_as<Record>(stored_record());
  const FirstLevels first = first_levels(record);
  EXPECT_TRUE(first.are_required);
  EXPECT_EQ(first.lead, "What was required is not met.");
  ASSERT_EQ(first.outcomes.size(), outcomes_of(record).size());
  EXPECT_EQ(first.outcomes[0].asked.text, "logic");
}

TEST(FirstLevels, AreThoseThatAreAdvisedWhereNothingWasRequired) {
  Json record = stored_record();
  record["plan"]["require"] = nullptr;
  const FirstLevels first = first_levels(read_as<Record>(record));
  EXPECT_FALSE(first.are_required);
  EXPECT_THAT(first.lead, StartsWith("Nothing was required. Advised: --require logic asks"));
  ASSERT_FALSE(first.outcomes.empty());
  EXPECT_EQ(first.outcomes[0].asked.text, "logic");
}

TEST(FirstLevels, SayTheFirstWayInWhichTheyFail) {
  LevelOutcome outcome;
  outcome.reason = "too few";
  EXPECT_EQ(reason_text(outcome), "too few");
  outcome.failures = {{"k", "binary32", "tangent", 12345, "missed contacts", "w1"}, {"k", "", "", 1, "a crash", ""}};
  EXPECT_EQ(reason_text(outcome), "tangent: missed contacts: 12,345; and 1 more");
}

// Both reports for people begin with them, with the worst wrong verdict and with the sentences.
TEST(FirstLevels, BeginBothReports) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string markdown = folder.read("report.md");
  EXPECT_THAT(markdown, HasSubstr("\n\n## The answer\n\nWhat was required is not met."));
  EXPECT_LT(markdown.find(
                "\nThe worst: published binary32 misses a contact, by 0.25 of the scene. Family tangent, witness w2."),
            markdown.find("\n## Summary"));
  EXPECT_LT(markdown.find("\n## Worst witnesses"), markdown.find("\n## Words"));
  const Json first = page_data(folder.read("report.html"))["first"];
  EXPECT_EQ(first["levels"].size(), outcomes_of(read_as<Record>(stored_record())).size());
  EXPECT_EQ(first["worst"]["id"], "w2");
  EXPECT_EQ(first["worst"]["precision"], "binary32");
  EXPECT_EQ(first["worst"]["group"], "other");
  const Json groups = page_data(folder.read("report.html"))["groups"];
  EXPECT_THAT(groups[0]["heading"].get<std::string>(), HasSubstr("Your own"));
  EXPECT_EQ(groups[0]["families"], Json::array({"mesh/a|b.obj"}));
}

}  // namespace
}  // namespace axiscert
