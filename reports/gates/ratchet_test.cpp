// The ratchet reads what it wrote, refuses what nobody has reviewed, and lets nothing get worse.
#include "reports/gates/ratchet.h"

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

TEST(Ratchet, WorseIsNamedWithTheLineThatWouldAcceptIt) {
  Json record = stored_record();
  tangent_counts(record)["comparisons"]["edge_bc.side_a"]["missed_separation"] = 2;
  tangent_counts(record)["verdict"]["false_separation"] = 41;
  tangent_counts(record)["verdict"]["deepest_false_contact"] = 0.75;
  const RatchetOutcome outcome = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today);
  EXPECT_THAT(
      texts(outcome.failures),
      ElementsAre(HasSubstr("published binary32 on tangent: verdict.false_separation: 41, accepted is 40 (r.txt:"),
                  HasSubstr("verdict.deepest_false_contact: 0.75, accepted is 0.125"),
                  HasSubstr("edge_bc.side_a.missed_separation: 2, accepted is 0; to accept it: ")));
  EXPECT_THAT(outcome.failures[2].text,
              HasSubstr("published binary32 tangent edge_bc.side_a.missed_separation 2 EXPIRY"));
  // Copying an unreviewed line does not accept it.
  EXPECT_THAT(error_of(outcome.accepted), HasSubstr("EXPIRY"));
}

TEST(Ratchet, BetterPrintsTheLineAndHolds) {
  Json record = stored_record();
  tangent_counts(record)["verdict"]["false_separation"] = 39;
  tangent_counts(record)["comparisons"]["vertex_a.radius"]["false_separation"] = 0;
  const RatchetOutcome outcome = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today);
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.better, ElementsAre(HasSubstr("verdict.false_separation 39 never mk \"rounds, see docs\""),
                                          HasSubstr("vertex_a.radius.false_separation: 0, accepted is 2")));
  EXPECT_THAT(hold_against(parse_ratchet(outcome.accepted, "r.txt"), record, today).better, IsEmpty());
}

TEST(Ratchet, AnExpiredWaiverFailsFromTheDayAfter) {
  const Json record = stored_record();
  const std::size_t lines = parse_ratchet(reviewed(), "r.txt").entries.size();
  EXPECT_THAT(hold_against(parse_ratchet(reviewed(today), "r.txt"), record, today).failures, IsEmpty());
  const auto failures = hold_against(parse_ratchet(reviewed("2026-06-14"), "r.txt"), record, today).failures;
  EXPECT_THAT(failures, SizeIs(lines));
  EXPECT_THAT(failures[0].text, HasSubstr("expired on 2026-06-14 (mk, rounds, see docs)"));
}

TEST(Ratchet, AKernelThatWasNotRunIsNotPassed) {
  Json record = stored_record();
  record["kernels"].erase(1);
  const auto failures = hold_against(parse_ratchet(reviewed(), "r.txt"), record, today).failures;
  ASSERT_THAT(failures, testing::Not(IsEmpty()));
  EXPECT_THAT(failures[0].text, HasSubstr("NOT CHECKED: this run did not judge <script> binary32"));
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

TEST(Ratchet, AnotherTestIsRefusedBeforeItsFiguresAreCompared) {
  std::string text = reviewed();
  text.insert(text.find('\n'), " point-box");
  const Ratchet ratchet = parse_ratchet(text, "r.txt");
  EXPECT_EQ(ratchet.test, "point-box");
  EXPECT_THAT([&] { hold_against(ratchet, stored_record(), today); },
              testing::ThrowsMessage<Error>("r.txt: of the test point-box, and this run is of sphere-triangle; figures "
                                            "of two tests are not comparable"));
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
  folder.write("ratchet.json", outcome_json(ratchet, hold_against(ratchet, record, today)).dump());
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
  EXPECT_THAT(folder.read("ratchet.txt"), HasSubstr(" never mk \"rounds, see docs\"\n"));
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
  folder.write("ratchet.json", outcome_json(ratchet, hold_against(ratchet, record, today)).dump());
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
  for (const auto& [old, with, says] : {std::array{"held/1", "held/2", "axiscert-held/2"},
                                        {"\"plan\":\"", "\"plan\":\"f", "belongs to another plan"},
                                        {"\"better\"", "\"bitter\"", "/bitter"}}) {
    folder.write("ratchet.json", replaced(good, old, with));
    EXPECT_THAT(folder.rendering_error(), testing::AllOf(HasSubstr("ratchet.json"), HasSubstr(says)));
  }
}

TEST(Ratchet, TheFingerprintIsTheCellsAloneAndTheSameForEver) {
  const std::string text = reviewed();
  EXPECT_THAT(text, HasSubstr("\nef4246591683df37 published binary32 tangent verdict.false_separation 40 never mk "));
  Json record = stored_record();
  record["plan"]["seed"] = 7;
  EXPECT_THAT(ratchet_text(record), HasSubstr("\nef4246591683df37 "));
}

TEST(Ratchet, NamesWithSpacesAndControlCharactersComeBack) {
  Json record = Json::parse(replaced(stored_record().dump(), "a|b.obj", "my \\\"mesh\\n# x.obj"));
  record["kernels"][0]["families"]["mesh/my \"mesh\n# x.obj"]["verdict"]["false_contact"] = 5;
  const std::string text = replaced(ratchet_text(record), " EXPIRY OWNER REASON\n", " never mk why\n");
  EXPECT_THAT(text, HasSubstr("\"mesh/my \\\"mesh\\n# x.obj\" verdict.false_contact 5 never"));
  EXPECT_THAT(hold_against(parse_ratchet(text, "r.txt"), record, today).failures, IsEmpty());
}

TEST(Ratchet, BadLinesAreNamed) {
  const std::string good = reviewed();
  EXPECT_EQ(error_of(good), "");
  EXPECT_THAT(error_of(""), HasSubstr("r.txt: empty"));
  EXPECT_THAT(error_of("{}\n"), HasSubstr("r.txt:1: begins with '{}'"));
  EXPECT_THAT(error_of(replaced(good, "ratchet/1", "ratchet/2")),
              HasSubstr("r.txt:1: begins with 'axiscert-ratchet/2'"));
  EXPECT_THAT(error_of(ratchet_text(stored_record())), HasSubstr("r.txt:3: EXPIRY 'EXPIRY' is neither a day"));
  EXPECT_THAT(error_of(replaced(good, " never ", " 2026-02-30 ")), HasSubstr("'2026-02-30' is neither a day"));
  EXPECT_THAT(error_of(replaced(good, " mk ", " OWNER ")), HasSubstr("OWNER is not filled in"));
  EXPECT_THAT(error_of(replaced(good, "\"rounds, see docs\"", "\"\"")), HasSubstr("REASON is not filled in"));
  EXPECT_THAT(error_of(replaced(good, "\"rounds, see docs\"", "rounds, see docs")), HasSubstr("11 words"));
  EXPECT_THAT(error_of(replaced(good, "see docs\"", "see docs")), HasSubstr("a quotation mark"));
  EXPECT_THAT(error_of(replaced(good, "tangent verdict.false_separation 40", "tangent verdict.false_separation -40")),
              HasSubstr("FIGURE '-40'"));
  EXPECT_THAT(error_of(replaced(good, "tangent verdict.false_separation", "general verdict.false_separation")),
              HasSubstr("is not that of published binary32 on general"));
  EXPECT_THAT(error_of(good + good.substr(good.find('\n') + 1)), HasSubstr("appears twice"));
}

}  // namespace
}  // namespace axiscert
