// A ratchet of a run of a predicate of motions: late times and tunnels that are accepted, and no more of them.
#include "reports/gates/ratchet_text.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/motion_run.h"

namespace axiscert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string day = "2026-06-15";

std::string accepted_motions() {
  std::string text = ratchet_text(motions(contacts(5, 0.25, 0)));
  const std::string open = "EXPIRY OWNER REASON\n";
  return text.replace(text.find(open), open.size(), "never mk \"rounds to nearest\"\n");
}

RatchetOutcome held(const Json& on_tangent) {
  return hold_against(parse_ratchet(accepted_motions(), "r.txt"), motions(on_tangent), day);
}

std::string refused_with(const std::string& text) {
  try {
    parse_ratchet(text, "r.txt");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(RatchetOfContacts, HasTheFiguresOfTimesAndNoErrorInU) {
  EXPECT_THAT(accepted_motions(), HasSubstr("\ntime late=5 early=100 deepest_tunnel=0.25\n"));
  EXPECT_THAT(accepted_motions(), Not(HasSubstr("latest_u")));
  EXPECT_THAT(held(contacts(5, 0.25, 0)).failures, IsEmpty());
}

TEST(RatchetOfContacts, OneLateTimeMoreFailsAndOneLessIsBetter) {
  const RatchetOutcome worse = held(contacts(9, 0.25, 0));
  ASSERT_EQ(worse.failures.size(), 1u);
  EXPECT_THAT(worse.failures[0].text,
              HasSubstr("<script> binary32 on tangent: time.late: 9 of 900, accepted is 5 (r.txt:"));
  const RatchetOutcome better = held(contacts(4, 0.25, 0));
  EXPECT_THAT(better.failures, IsEmpty());
  EXPECT_THAT(better.better, ElementsAre(HasSubstr("time.late: 4 of 900, accepted is 5")));
}

TEST(RatchetOfContacts, TimesThatAreNotShownAnyMoreAreNotCheckedAndStayAccepted) {
  Json silent = contacts(5, 0.25, 0);
  silent["time"] = nullptr;
  const RatchetOutcome outcome = held(silent);
  ASSERT_EQ(outcome.failures.size(), 1u);
  EXPECT_THAT(outcome.failures[0].text,
              HasSubstr("NOT CHECKED: this run does not show what the ratchet has: 3 figures of"));
  EXPECT_THAT(outcome.better, IsEmpty());
  for (const char* figure : {"late=5", "early=100", "deepest_tunnel=0.25"})
    EXPECT_THAT(outcome.accepted, HasSubstr(figure));
}

TEST(RatchetOfContacts, ATunnelThatIsDeeperFails) {
  const RatchetOutcome worse = held(contacts(5, 0.5, 0.125));
  ASSERT_EQ(worse.failures.size(), 2u);
  EXPECT_THAT(worse.failures[0].text + worse.failures[1].text, HasSubstr("time.deepest_tunnel: 0.5, accepted is 0.25"));
  EXPECT_THAT(worse.failures[0].text + worse.failures[1].text,
              HasSubstr("missed.deepest_tunnel: 0.125, accepted is 0"));
}

TEST(RatchetOfContacts, APlaceOrFigureThatThePredicateDoesNotHaveIsRefused) {
  const std::string motions = "axiscert-ratchet/3 p moving-sphere\n",
                    lines =
                        "kernel: k\npromise: binary32 queries=9 touching=contact\n"
                        "accept: never mk why\nfamily: binary32 f\n";
  EXPECT_THAT(refused_with("axiscert-ratchet/3 p\n" + lines + "time late=5\n"),
              HasSubstr("'time' is no place of a figure"));
  EXPECT_THAT(refused_with(motions + lines + "time tardy=5\n"),
              HasSubstr("late, early, none, invalid, through, deepest_tunnel"));
  EXPECT_EQ(refused_with(motions + lines + "time late=5\nmissed through=1\nfeature wrong=2\n"), "");
}

TEST(RatchetOfContacts, ItsFailuresAreInTheCaseOfTheFamilysVerdict) {
  const TestFolder folder(motions(contacts(9, 0.25, 0)));
  folder.write("ratchet.json", json_of(held(contacts(9, 0.25, 0))).dump());
  render_reports(folder.path());
  const std::string junit = folder.read("junit.xml");
  const std::size_t begin = junit.find("name=\"tangent verdict\"");
  ASSERT_NE(begin, junit.npos);
  EXPECT_THAT(junit.substr(begin, junit.find("</testcase>", begin) - begin), HasSubstr("time.late: 9 of 900"));
  EXPECT_THAT(junit, Not(HasSubstr("testsuite name=\"ratchet\"")));
}

}  // namespace
}  // namespace axiscert
