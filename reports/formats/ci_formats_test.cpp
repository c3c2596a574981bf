// The contents of junit.xml and report.sarif.
#include "fuzz/text/json_form.h"
#include "reports/testing/test_run.h"

#include <map>

#include "reports/gates/ratchet.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Junit, FailsWhereTheRequirementOrATolerancePasses) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string text = folder.read("junit.xml");
  // published: tangent's verdict and plane.radius; skipped: fifteen comparisons without a tolerance on three families.
  // <script>: lattice's verdict; skipped: tangent's, since a wrong verdict there may be of rounding, its comparisons,
  // once, as it does not show them, and its mesh, on which it was not run.
  EXPECT_THAT(text, HasSubstr("tests=\"51\" failures=\"2\" errors=\"0\" skipped=\"45\""));
  EXPECT_THAT(text, HasSubstr("tests=\"4\" failures=\"1\" errors=\"0\" skipped=\"3\""));
  EXPECT_THAT(text, HasSubstr("name=\"tangent plane.radius\""));
  EXPECT_THAT(text, HasSubstr("3 errors above 2 u; the smallest tolerance that passes is 3.5 u"));
}

TEST(Junit, WithoutARequirementVerdictsAreSkippedNotPassed) {
  Json record = stored_record();
  record["plan"]["require"] = nullptr;
  record["plan"]["tolerance"] = Json::object();
  const TestFolder folder(record);
  render_reports(folder.path());
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("tests=\"51\" failures=\"0\" errors=\"0\" skipped=\"51\""));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("tests=\"4\" failures=\"0\" errors=\"0\" skipped=\"4\""));
}

TEST(Junit, EscapesNamesAndControlCharacters) {
  const TestFolder folder(named(std::string("<a & \"b\">\x01\x1b\xEF\xBF\xBF\n")));
  render_reports(folder.path());
  const std::string text = folder.read("junit.xml");
  EXPECT_THAT(text, HasSubstr("&lt;a &amp; &quot;b&quot;&gt;\\u0001\\u001b\xEF\xBF\xBD\\n"));
  EXPECT_EQ(text.find('\x01'), text.npos);
}

// Code scanning shows a message as text, another viewer may not: it is JSON either way, and reads back as it is shown.
TEST(Sarif, NamesComeBackAndResultsStandAtTheirWitness) {
  const std::string evil = "</script><script>alert(1)</script>\"\n";
  const TestFolder folder(named(evil));
  render_reports(folder.path());
  const Json log = Json::parse(folder.read("report.sarif")), record = named(evil);
  bool is_named = false;
  for (const Json& result : log["runs"][0]["results"]) {
    const Json& place = result["locations"][0];
    is_named |= place["logicalLocations"][0]["fullyQualifiedName"].get<std::string>().starts_with(printable_line(evil) +
                                                                                                  "/binary32/");
    if (result["message"]["text"].get<std::string>().find("Reproduced by") == std::string::npos) continue;
    const std::size_t line = place["physicalLocation"]["region"]["startLine"];
    ASSERT_LE(line, record["witnesses"].size());
    EXPECT_NE(place["logicalLocations"][0]["fullyQualifiedName"].get<std::string>().find(
                  record["witnesses"][line - 1]["family"].get<std::string>()),
              std::string::npos);
  }
  EXPECT_TRUE(is_named);
}

// In text SARIF's viewers turn [text](target) into a link and fill in {0}.
TEST(Sarif, NamesAreNoLinks) {
  const TestFolder folder(named("[x](https://a.example){0}\\"));
  render_reports(folder.path());
  const Json log = Json::parse(folder.read("report.sarif"));
  std::size_t shown = 0;
  for (const Json& result : log["runs"][0]["results"]) {
    const std::string text = result["message"]["text"];
    EXPECT_THAT(text, Not(HasSubstr("[x](")));
    shown += occurrences(text, "\\[x\\](https://a.example){{0}}\\\\") != 0;
  }
  EXPECT_GT(shown, 0u);
}

// The results of the stored run, by the name of their cell, with this run.json and this ratchet.json.
std::map<std::string, Json> sarif_results(const Json& info, const Json& held = nullptr) {
  const TestFolder folder(stored_record());
  if (!info.is_null()) folder.write("run.json", info.dump());
  if (!held.is_null()) folder.write("ratchet.json", held.dump());
  render_reports(folder.path());
  std::map<std::string, Json> results;
  const Json log = Json::parse(folder.read("report.sarif"));
  for (const Json& result : log["runs"][0]["results"])
    results[result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]] = result;
  return results;
}

TEST(Sarif, AKernelsSourceIsTheLocationAndTheWitnessIsRelated) {
  Json info = stored_run_info();
  info["sources"] = {{"published", {{"file", "src/my kernel#1.c"}, {"line", 12}}}};
  const auto results = sarif_results(info);
  const Json& result = results.at("published/binary32/tangent/verdict.false_contact");
  const auto place = [](const Json& location) { return location["physicalLocation"]; };
  EXPECT_EQ(place(result["locations"][0])["artifactLocation"]["uri"], "src/my%20kernel%231.c");
  EXPECT_EQ(place(result["locations"][0])["region"]["startLine"], 12);
  EXPECT_EQ(place(result["relatedLocations"][0])["artifactLocation"]["uri"], "witnesses.jsonl");
  // Nothing is known of the other kernel.
  const Json& other = results.at("<script>/binary32/tangent/verdict.false_separation");
  EXPECT_EQ(place(other["locations"][0])["artifactLocation"]["uri"], "witnesses.jsonl");
  EXPECT_FALSE(other.contains("relatedLocations"));
}

TEST(Sarif, WhatTheRatchetAcceptsIsASuppressedNote) {
  const Record record = read_as<Record>(stored_record());
  std::string text = ratchet_text(record);
  const std::string open = "EXPIRY OWNER REASON";
  text.replace(text.find(open), open.size(), "2030-01-01 mk \"as published\"");
  const auto at = text.find("deepest_false_separation=0.25");
  text.replace(at, 29, "deepest_false_separation=0.125");
  const Ratchet ratchet = parse_ratchet(text, "accepted.txt");
  const auto results = sarif_results(nullptr, json_of(hold_against(ratchet, record, "2026-06-15")));
  // The requirement logic, which the stored run does not meet on tangent and lattice, has nothing to do with
  // comparisons.
  const Json& held = results.at("published/binary32/tangent/edge_ab.side_c.false_separation");
  EXPECT_EQ(held["level"], "note");
  EXPECT_EQ(held["suppressions"][0],
            Json({{"kind", "external"},
                  {"status", "accepted"},
                  {"justification", "accepted in accepted.txt until 2030-01-01 by mk: as published"}}));
  EXPECT_EQ(results.at("published/binary32/tangent/plane.radius.tolerance_failures")["level"], "note");
  const Json& unmet = results.at("published/binary32/tangent/verdict.false_contact");
  EXPECT_EQ(unmet["level"], "error") << "what the requirement refuses no ratchet accepts";
  // SARIF wants the member in all results or in none.
  for (const auto& [name, result] : results) EXPECT_TRUE(result["suppressions"].is_array()) << name;
  const Json& deeper = results.at("<script>/binary32/tangent/verdict.false_separation");
  EXPECT_EQ(deeper["suppressions"].size(), 1u) << "its own depth is accepted";
  EXPECT_TRUE(results.at("published/binary32/tangent/verdict.deepest_false_separation")["suppressions"].empty());
  for (const auto& [name, result] : sarif_results(nullptr)) EXPECT_FALSE(result.contains("suppressions")) << name;
}

TEST(Junit, ARatchetPassesNoFamilyThatWasNotDecided) {
  Json json = stored_record();
  json["plan"]["require"] = nullptr;
  const auto published = [&](const Json& record) {
    std::string text = ratchet_text(read_as<Record>(record));
    const std::string open = "EXPIRY OWNER REASON";
    for (std::size_t at = text.find(open); at != text.npos; at = text.find(open, at))
      text.replace(at, open.size(), "2030-01-01 mk \"as published\"");
    const TestFolder folder(record);
    folder.write(
        "ratchet.json",
        json_of(hold_against(parse_ratchet(text, "accepted.txt"), read_as<Record>(record), "2026-06-15")).dump());
    render_reports(folder.path());
    const std::string junit = folder.read("junit.xml");
    return junit.substr(0, junit.find("&lt;script&gt; binary32"));
  };
  const std::string passes = "name=\"lattice verdict\" time=\"0\"/>";
  EXPECT_THAT(published(json), HasSubstr(passes));
  Json& verdict = json["kernels"][0]["families"]["lattice"]["verdict"];
  for (const char* decided : {"decided", "decided_contacts", "decided_separations", "decided_touching"})
    verdict[decided] = 0;
  verdict["undecided"] = 500;
  verdict["undecided_contact"] = 300;
  verdict["undecided_touching"] = 60;
  EXPECT_THAT(published(json), testing::Not(HasSubstr(passes)));
}

TEST(Sarif, AResultACellThatIsNotZero) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  std::map<std::string, std::string> levels;
  const Json log = Json::parse(folder.read("report.sarif"));
  for (const Json& result : log["runs"][0]["results"]) {
    levels[result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]] = result["level"];
    EXPECT_EQ(log["runs"][0]["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"],
              result["ruleId"]);
  }
  EXPECT_EQ(levels["published/binary32/tangent/verdict.false_contact"], "error")
      << "requirement logic is not met there";
  EXPECT_EQ(levels["published/binary32/tangent/edge_ab.side_c.false_separation"], "note");
  EXPECT_EQ(levels["published/binary32/tangent/plane.radius.tolerance_failures"], "error");
  EXPECT_EQ(levels.count("published/binary32/lattice/verdict.false_contact"), 0u);
}

TEST(Sarif, ALateTimeIsAWarningAndAnEarlyOneANote) {
  const TestFolder folder(grown(motions(contacts(7, 0.5, 0))));
  render_reports(folder.path());
  std::map<std::string, Json> results;
  const Json log = Json::parse(folder.read("report.sarif"));
  for (const Json& result : log["runs"][0]["results"]) results[result["ruleId"]] = result;
  ASSERT_TRUE(results.contains("late-time"));
  EXPECT_EQ(results["late-time"]["level"], "warning");
  EXPECT_EQ(results["early-time"]["level"], "note");
  EXPECT_FALSE(results.contains("no-time") || results.contains("invalid-time"));
  const std::string text = results["late-time"]["message"]["text"];
  EXPECT_NE(text.find("7 of 900 contacts found"), std::string::npos) << text;
}

// Late times are a warning, and a size is in no cell with a rule: the level is the result, with its witness.
TEST(Sarif, ALevelThatNoOtherErrorStandsForIsOne) {
  Json record = grown(motions(contacts(7, 0.5, 0)));
  record["plan"]["require"] = {"never-late", "exact"};
  const TestFolder folder(record);
  render_reports(folder.path());
  std::map<std::string, Json> results;
  const Json log = Json::parse(folder.read("report.sarif"));
  for (const Json& result : log["runs"][0]["results"])
    results[result["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]] = result;
  EXPECT_FALSE(results.contains("<script>/binary32/tangent/requirement.exact")) << "missed contacts stand for it";
  ASSERT_TRUE(results.contains("<script>/binary32/tangent/requirement.never-late"));
  const Json& result = results["<script>/binary32/tangent/requirement.never-late"];
  EXPECT_EQ(result["ruleId"], "requirement-not-met");
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(log["runs"][0]["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
  EXPECT_THAT(result["message"]["text"].get<std::string>(),
              testing::AllOf(HasSubstr("never-late is not met."), HasSubstr("Reproduced by: ")));
}

}  // namespace
}  // namespace axiscert
