// The ratchet reads what it wrote, refuses what nobody has reviewed, and lets nothing get worse.
#include "fuzz/text/json_form.h"
#include "reports/gates/ratchet.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* today = "2026-06-15";

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

// The stored record's ratchet, reviewed.
std::string reviewed(const std::string& expiry = "never") {
  return replaced(ratchet_text(stored_record()), " EXPIRY OWNER REASON\n", " " + expiry + " mk \"rounds, see docs\"\n");
}

std::string error_of(const std::string& text) {
  try {
    parse_ratchet(text, "r.txt");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> texts(const std::vector<RatchetFailure>& failures) {
  std::vector<std::string> all;
  for (const RatchetFailure& failure : failures) all.push_back(failure.text);
  return all;
}

TEST(Ratchet, TheReviewedStateHolds) {
  const RatchetOutcome outcome = hold_against(parse_ratchet(reviewed(), "r.txt"), stored_record(), today);
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.better, IsEmpty());
  EXPECT_EQ(parse_ratchet(outcome.accepted, "again").entries.size(), parse_ratchet(reviewed(), "r").entries.size());
}

// Missed contacts before phantom ones, and both before a comparison under a right verdict.
TEST(Ratchet, WorseIsNamedTheWorstFirst) {
  Json record = stored_record();
  tangent_counts(record)["comparisons"]["edge_bc.side_a"]["missed_separation"] = 2;
  tangent_counts(record)["verdict"]["false_separation"] = 41;
  tangent_counts(record)["verdict"]["deepest_false_contact"] = 0.75;
  const RatchetOutcome outcome = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today);
  EXPECT_THAT(
      texts(outcome.failures),
      ElementsAre(HasSubstr("published binary32 on tangent: verdict.false_separation: 41, accepted is 40 (r.txt:"),
                  HasSubstr("verdict.deepest_false_contact: 0.75, accepted is 0.125"),
                  HasSubstr("edge_bc.side_a.missed_separation: 2, accepted is 0")));
  for (const std::string& text : texts(outcome.failures)) EXPECT_EQ(occurrences(text, "\n"), 0u) << text;
  EXPECT_THAT(outcome.accepted, HasSubstr("accept: EXPIRY OWNER REASON\nkernel: published\nfamily: binary32 tangent\n"
                                          "verdict false_separation=41 deepest_false_contact=0.75\n"
                                          "edge_bc.side_a missed_separation=2\n"));
  // Copying an unreviewed line does not accept it.
  EXPECT_THAT(error_of(outcome.accepted), HasSubstr("EXPIRY"));
}

TEST(Ratchet, BetterPrintsTheLineAndHolds) {
  Json record = stored_record();
  tangent_counts(record)["verdict"]["false_separation"] = 39;
  tangent_counts(record)["comparisons"]["vertex_a.radius"]["false_separation"] = 0;
  const RatchetOutcome outcome = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today);
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.better, ElementsAre(HasSubstr("verdict.false_separation: 39, accepted is 40 (r.txt:"),
                                          HasSubstr("vertex_a.radius.false_separation: 0, accepted is 2")));
  EXPECT_THAT(hold_against(parse_ratchet(outcome.accepted, "r.txt"), record, today).better, IsEmpty());
}

TEST(Ratchet, AnExpiredWaiverFailsFromTheDayAfter) {
  const Json record = stored_record();
  EXPECT_THAT(hold_against(parse_ratchet(reviewed(today), "r.txt"), record, today).failures, IsEmpty());
  const auto failures = hold_against(parse_ratchet(reviewed("2026-06-14"), "r.txt"), record, today).failures;
  EXPECT_THAT(texts(failures),
              ElementsAre(HasSubstr("expired on 2026-06-14 (mk, rounds, see docs): 10 figures of published"),
                          HasSubstr("8 figures of <script> binary32 (r.txt:")))
      << "one line for each kernel and precision, whatever number of figures has expired";
}

TEST(Ratchet, AKernelThatWasNotRunIsNotPassed) {
  Json record = stored_record();
  record["kernels"].erase(1);
  const auto failures = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today).failures;
  EXPECT_THAT(texts(failures),
              ElementsAre(HasSubstr(
                  "NOT CHECKED: this run did not judge <script> binary32, of which the ratchet has: 8 figures of "
                  "<script> binary32 (r.txt:")));
}

TEST(Ratchet, AnotherPlanIsRefused) {
  const Ratchet ratchet = parse_ratchet(reviewed(), "r.txt");
  for (const auto& [member, value] :
       {std::pair<const char*, Json>{"seed", 7}, {"tolerance", Json::object()}, {"units_done", Json::object()}}) {
    Json record = stored_record();
    record["plan"][member] = value;
    EXPECT_THROW(hold_against(ratchet, record, today), Error) << member;
  }
}

TEST(Ratchet, AnotherPredicateIsRefusedBeforeItsFiguresAreCompared) {
  std::string text = reviewed();
  text.insert(text.find('\n'), " point-box");
  const Ratchet ratchet = parse_ratchet(text, "r.txt");
  EXPECT_EQ(ratchet.predicate, "point-box");
  EXPECT_THAT(
      [&] { hold_against(ratchet, stored_record(), today); },
      testing::ThrowsMessage<Error>("r.txt: of the predicate point-box, and this run is of sphere-triangle; figures "
                                    "of two predicates are not comparable"));
  text.insert(text.find('\n'), " more");
  EXPECT_THAT(error_of(text), HasSubstr("r.txt:1: begins with"));
}

// The stored record with one comparison worse than accepted, and the ratchet's outcome.
void write_held(const TestFolder& folder) {
  Json record = stored_record();
  Json& comparison = tangent_counts(record)["comparisons"]["edge_bc.side_a"];
  comparison["missed_separation"] = comparison["masked"] = 2;
  const Ratchet ratchet = parse_ratchet(reviewed(), "r.txt");
  folder.write("record.json", record.dump());
  folder.write("ratchet.json", json_of(hold_against(ratchet, record, today)).dump());
}

TEST(Ratchet, EveryFormatTellsOfIt) {
  const TestFolder folder;
  write_held(folder);
  ASSERT_EQ(folder.rendering_error(), "");
  const std::string worse = "published binary32 on tangent: edge_bc.side_a.missed_separation: 2, accepted is 0";
  const std::string junit = folder.read("junit.xml"), name = "name=\"tangent edge_bc.side_a\"";
  const std::string of_case =
      junit.substr(junit.find(name), junit.find("</testcase>", junit.find(name)) - junit.find(name));
  EXPECT_THAT(of_case, HasSubstr("<failure type=\"ratchet\""));
  EXPECT_THAT(of_case, HasSubstr(worse));
  EXPECT_EQ(occurrences(junit, worse), 1u);
  // Compared with the ratchet and not worse: counts as checked where nothing else was required.
  EXPECT_THAT(junit, HasSubstr("name=\"tangent edge_ab.side_c\" time=\"0\"/>"));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("edge_bc.side_a.missed_separation: 2, accepted is 0"));
  EXPECT_THAT(folder.read("ratchet.txt"), HasSubstr("accept: never mk \"rounds, see docs\"\n"));
  const Json log = Json::parse(folder.read("report.sarif"))["runs"][0];
  std::size_t found = 0;
  for (const Json& result : log["results"]) {
    if (result["ruleId"] != "worse-than-accepted") continue;
    ++found;
    EXPECT_EQ(log["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], "worse-than-accepted");
    EXPECT_EQ(result["level"], "error");
    EXPECT_THAT(result["message"]["text"].get<std::string>(), HasSubstr(worse));
  }
  EXPECT_EQ(found, 1u);
}

TEST(Ratchet, AFailureWithoutACaseHasASuiteOfItsOwn) {
  Json record = stored_record();
  record["kernels"].erase(1);
  const TestFolder folder(record);
  // A record that lacks a kernel of its plan is not valid: this outcome is written next to the complete record.
  const Ratchet ratchet = parse_ratchet(reviewed(), "r.txt");
  folder.write("ratchet.json", json_of(hold_against(ratchet, record, today)).dump());
  folder.write("record.json", stored_record().dump());
  Json held = Json::parse(folder.read("ratchet.json"));
  for (Json& failure : held["failures"]) failure["kernel"] = "gone";
  folder.write("ratchet.json", held.dump());
  ASSERT_EQ(folder.rendering_error(), "");
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("<testsuite name=\"ratchet\""));
}

TEST(Ratchet, AnOutcomeOfAnotherPlanOrFormIsRefused) {
  const TestFolder folder;
  write_held(folder);
  const std::string good = folder.read("ratchet.json");
  for (const auto& [old, with, says] : {std::array{"held/3", "held/2", "axiscert-held/2"},
                                        {"\"plan\":\"", "\"plan\":\"f", "belongs to another plan"},
                                        {"\"better\"", "\"bitter\"", "without \"better\""}}) {
    folder.write("ratchet.json", replaced(good, old, with));
    EXPECT_THAT(folder.rendering_error(), testing::AllOf(HasSubstr("ratchet.json"), HasSubstr(says)));
  }
}

TEST(Ratchet, TheFingerprintIsTheCellsAloneAndTheSameForEver) {
  EXPECT_EQ(parse_ratchet(reviewed(), "r.txt").entries.at("ef4246591683df37").key,
            Json::array({"published", "binary32", "tangent", "verdict.false_separation"}));
}

TEST(Ratchet, NamesWithSpacesAndControlCharactersComeBack) {
  Json record = Json::parse(replaced(stored_record().dump(), "a|b.obj", "my \\\"mesh\\n# x.obj"));
  record["kernels"][0]["families"]["mesh/my \"mesh\n# x.obj"]["verdict"]["false_contact"] = 5;
  const std::string text = replaced(ratchet_text(record), " EXPIRY OWNER REASON\n", " never mk why\n");
  EXPECT_THAT(text, HasSubstr("\nfamily: binary32 \"mesh/my \\\"mesh\\\\n# x.obj\"\nverdict false_contact=5"));
  EXPECT_THAT(hold_against(parse_ratchet(text, "r.txt"), record, today).failures, IsEmpty());
}

TEST(Ratchet, WhatIsAlikeIsWrittenOnce) {
  const std::string text = ratchet_text(stored_record());
  EXPECT_EQ(occurrences(text, "EXPIRY OWNER REASON"), 1u);
  EXPECT_EQ(occurrences(text, "published"), 2u) << "once for its promise, once for its figures";
  EXPECT_EQ(occurrences(text, "family: binary32 tangent\n"), 2u) << "once for each kernel";
}

// Two waivers in one file, and what is worse than both apart from them.
TEST(Ratchet, EachFigureKeepsItsWaiver) {
  std::string text = reviewed();
  text.insert(text.rfind("kernel: <script>"), "accept: 2026-12-31 geometry \"to be mended\"\n");
  Json record = stored_record();
  tangent_counts(record)["verdict"]["false_separation"] = 41;
  const RatchetOutcome outcome = hold_against(parse_ratchet(text, "r.txt"), record, today);
  EXPECT_THAT(outcome.failures, SizeIs(1));
  EXPECT_THAT(outcome.held,
              ElementsAre(testing::Field(&WaivedCells::waiver, Waiver{"never", "mk", "rounds, see docs"}),
                          testing::Field(&WaivedCells::waiver, Waiver{"2026-12-31", "geometry", "to be mended"})));
  const std::string filled = replaced(outcome.accepted, "EXPIRY OWNER REASON", "never mk \"rounds, see docs\"");
  const RatchetOutcome again = hold_against(parse_ratchet(filled, "r.txt"), record, today);
  EXPECT_THAT(again.failures, IsEmpty());
  EXPECT_EQ(again.held.size(), 2u);
}

TEST(Ratchet, BadLinesAreNamed) {
  const std::string good = reviewed();
  EXPECT_EQ(error_of(good), "");
  const auto with = [&](const std::string& old, const std::string& now) { return error_of(replaced(good, old, now)); };
  EXPECT_THAT(error_of(""), HasSubstr("r.txt: empty"));
  EXPECT_THAT(error_of("{}\n"), HasSubstr("r.txt:1: begins with '{}'"));
  for (const char* other : {"ratchet/1", "ratchet/4", "ratchet/6"})
    EXPECT_THAT(with("ratchet/5", other),
                HasSubstr(fmt::format("r.txt:1: 'axiscert-{}' is of another version than 'axiscert-ratchet/5', which "
                                      "this axiscert reads; run without --ratchet, and review the ratchet.txt",
                                      other)));
  EXPECT_THAT(error_of(ratchet_text(stored_record())), HasSubstr("r.txt:7: EXPIRY 'EXPIRY' is neither a day"));
  EXPECT_THAT(with(" never ", " 2026-02-30 "), HasSubstr("'2026-02-30' is neither a day"));
  EXPECT_THAT(with(" mk ", " OWNER "), HasSubstr("OWNER is not filled in"));
  EXPECT_THAT(with("\"rounds, see docs\"", "\"\""), HasSubstr("REASON is not filled in"));
  EXPECT_THAT(with("\"rounds, see docs\"", "rounds, see docs"), HasSubstr("5 words after accept:"));
  EXPECT_THAT(with("see docs\"", "see docs"), HasSubstr("a quotation mark"));
  EXPECT_THAT(with("false_separation=40", "false_separation=-40"), HasSubstr("FIGURE '-40'"));
  EXPECT_THAT(
      with("verdict false_separation=40", "verdict missed=40"),
      HasSubstr("'missed=40' is not FIGURE=NUMBER with a figure of 'verdict': false_separation, false_contact"));
  EXPECT_THAT(with("vertex_a.radius false", "vertex_a.radios false"), HasSubstr("'vertex_a.radios' is no place"));
  EXPECT_THAT(with("family: binary32", "family: binary16"), HasSubstr("PRECISION 'binary16'"));
  EXPECT_THAT(with("kernel: published", "kernel: published plugin:1234"),
              HasSubstr("'plugin:1234' is not FILE:SHA256"));
  EXPECT_THAT(with("accept: never mk \"rounds, see docs\"\n", ""),
              HasSubstr("'verdict' before accept: says until when"));
  EXPECT_THAT(with("kernel: published\n", ""), HasSubstr("promise: before kernel: says whose"));
  EXPECT_THAT(with("family: binary32 lattice\n", ""), HasSubstr("appears twice"));
}

}  // namespace

// A ratchet of a run of a predicate of motions: late times and tunnels that are accepted, and no more of them.

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

TEST(RatchetOfContacts, TimesThatAreNotShownAnyMoreAreLess) {
  Json silent = contacts(5, 0.25, 0);
  silent["time"]["given"]["contacts"] = 400;
  silent["time"]["given"]["which_contacts"] = "7";
  const RatchetOutcome less = held(silent);
  ASSERT_EQ(less.failures.size(), 1u);
  EXPECT_THAT(less.failures[0].text, HasSubstr("shows less than the ratchet: time beside 1,300 of 1,800 contacts, "));
  EXPECT_THAT(less.better, IsEmpty());

  const std::string all = accepted_motions();
  const std::size_t at = all.find(" time="), end = all.find('\n', at);
  EXPECT_THAT(refused_with(all.substr(0, at) + all.substr(end)), HasSubstr("does not show time; take that line from"));
}

TEST(RatchetOfContacts, ATunnelThatIsDeeperFails) {
  const RatchetOutcome worse = held(contacts(5, 0.5, 0.125));
  ASSERT_EQ(worse.failures.size(), 2u);
  EXPECT_THAT(worse.failures[0].text + worse.failures[1].text, HasSubstr("time.deepest_tunnel: 0.5, accepted is 0.25"));
  EXPECT_THAT(worse.failures[0].text + worse.failures[1].text,
              HasSubstr("missed.deepest_tunnel: 0.125, accepted is 0"));
}

TEST(RatchetOfContacts, APlaceOrFigureThatThePredicateDoesNotHaveIsRefused) {
  const std::string motions = "axiscert-ratchet/5 p moving-sphere\n",
                    lines =
                        "kernel: k\npromise: binary32 queries=9 touching=contact "
                        "time=9@a,0 feature=9@a,0 normal=9@a,0 point=9@a,0\n"
                        "accept: never mk why\nfamily: binary32 f\n";
  EXPECT_THAT(refused_with("axiscert-ratchet/5 p\n" + lines), HasSubstr("shows 'time', which is none of: "));
  EXPECT_THAT(refused_with("axiscert-ratchet/5 p\n" + replaced(lines, "time=9@a,0 ", "") + "time late=5\n"),
              HasSubstr("'time' is no place of a figure"));
  EXPECT_THAT(refused_with(motions + lines + "time tardy=5\n"),
              HasSubstr("late, early, none, invalid, through, deepest_tunnel"));
  EXPECT_EQ(refused_with(motions + lines + "time late=5\nmissed through=1\nfeature wrong=2\n"), "");
  EXPECT_EQ(refused_with(motions + lines + "normal largest_angle=0.5\npoint largest_error=0.25\n"), "");
}

TEST(RatchetOfContacts, ItsFailuresAreInTheCaseOfTheFamilysVerdict) {
  const TestFolder folder(grown(motions(contacts(9, 0.25, 0))));
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
