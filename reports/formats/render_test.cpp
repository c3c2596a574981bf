// The contents of the reports; no name in a record may become markup.
#include "reports/testing/test_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>

#include "reports/page/embedded.h"
#include "reports/wording/markdown_text.h"
#include "reports/gates/ratchet_text.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

// A record whose kernel, family, mesh and witness carry `name`.
Json named(const std::string& name) {
  std::string text = stored_record().dump();
  for (const std::string old : {"<script>", "a|b.obj"}) {
    const std::string quoted = Json(name).dump();
    const std::string replacement = quoted.substr(1, quoted.size() - 2);
    for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + replacement.size())) {
      text.replace(at, old.size(), replacement);
    }
  }
  return Json::parse(text);
}

TEST(Html, NamesInTheDataAreInert) {
  const std::string evil = "</script><script>alert(1)</script><!--/*JS*/&\xE2\x80\xA8\xE2\x80\xA9";
  const TestFolder folder(named(evil)), plain(stored_record());
  render_reports(folder.path());
  render_reports(plain.path());
  const std::string html = folder.read("report.html");
  EXPECT_EQ(occurrences(html, "<script"), occurrences(plain.read("report.html"), "<script"));
  EXPECT_EQ(occurrences(html, "</script"), 3u);
  EXPECT_THAT(html, Not(HasSubstr("alert(1)")));
  EXPECT_THAT(html, Not(HasSubstr("<!--")));
  EXPECT_EQ(page_data(html)["kernels"][1]["id"], evil);
}

// page_test.mjs counts a browser's requests; this test looks for what could cause one.
TEST(Html, AsksNothingOfTheNetwork) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  std::string html = folder.read("report.html");
  for (const std::string_view known : {embedded::chart_min_js, std::string_view("http://www.w3.org/2000/svg")}) {
    const std::size_t at = html.find(known);
    ASSERT_NE(at, html.npos);
    html.erase(at, known.size());
  }
  for (const char* word : {"http://", "https://", " src=", "@import", "url(", "fetch("}) {
    EXPECT_THAT(html, Not(HasSubstr(word)));
  }
  EXPECT_THAT(html, HasSubstr("default-src 'none'"));
}

TEST(Html, CarriesSumsLimitsAndTheRequirement) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const Json data = page_data(folder.read("report.html"));
  const Json& all = data["kernels"][0]["all"];
  EXPECT_EQ(all["trials"], 4500);
  EXPECT_EQ(all["verdict"]["deepest"], 0.25);
  EXPECT_EQ(all["comparisons"]["plane.radius"]["tolerance_failures"], 3);
  EXPECT_TRUE(all["comparisons"]["vertex_a.radius"]["tolerance_failures"].is_null());
  EXPECT_EQ(all["comparisons"]["plane.radius"]["max_error_u"], 3.5);
  EXPECT_EQ(all["critical_radius"]["median_ulps"], 0.25);
  // 1e6 (1 - 0.05^(1/12)): the mesh's 3000 queries share 12 triangles.
  EXPECT_NEAR(data["kernels"][0]["families"]["mesh/a|b.obj"]["zero_limit_per_million"].get<double>(), 220922.2, 0.1);
  EXPECT_EQ(data["requirement"]["failures"].size(), unmet(stored_record(), "logic").size());
  EXPECT_FALSE(data["plan"].contains("seed"));
}

TEST(Html, ErrorBeyondBinary64IsALargestError) {
  Json record = stored_record();
  for (auto [family, error] : {std::pair{"tangent", "3.24761e+637"}, {"lattice", "9e+636"}}) {
    Json& tally = record["kernels"][0]["families"][family]["comparisons"]["plane.radius"];
    tally["max_error_u"] = tally["smallest_passing_tolerance"] = error;
  }
  const TestFolder folder(record);
  render_reports(folder.path());
  const Json all = page_data(folder.read("report.html"))["kernels"][0]["all"];
  EXPECT_EQ(all["comparisons"]["plane.radius"]["max_error_u"], "3.24761e+637");
  EXPECT_THAT(folder.read("report.md"), HasSubstr("| 3.24761e+637 |"));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("3.24761e+637 u"));
}

TEST(Html, StaysUnderThreeMegabytesWithTenThousandWitnesses) {
  constexpr int count = 10000 / TRIAL_DIVISOR;
  Json record = stored_record();
  std::mt19937_64 random(1);
  const auto number = [&] { return fmt::format("0x1.{:06x}p+0", (random() >> 41) << 1); };
  for (int i = 0; i < count; ++i) {
    Json witness = record["witnesses"][0];
    witness["id"] = "many" + std::to_string(i);
    witness["depth"] = (i + 1.0) / count;
    for (const char* point : {"a", "b", "c", "p"}) witness[point] = {number(), number(), number()};
    witness["r"] = number();
    for (const char* name : {"plane.radius", "vertex_a.radius", "edge_ab.radius", "edge_ab.side_c"}) {
      const std::string digits = fmt::format("0.{}", 10000000000000000 + random() % 9999999999999999);
      witness["sides"][name] = {{"exact", {{"lhs", digits}, {"rhs", digits}, {"margin", digits}}},
                                {"computed", {{"lhs", number()}, {"rhs", number()}}},
                                {"lhs_ulps", 0.001 * i},
                                {"rhs_ulps", nullptr},
                                {"error_u", 0.5}};
    }
    record["witnesses"].push_back(witness);
  }
  const TestFolder folder(record);
  render_reports(folder.path());
  const std::string html = folder.read("report.html");
  EXPECT_LT(html.size(), 3'000'000u);
  const Json witnesses = page_data(html)["witnesses"];
  EXPECT_EQ(witnesses["total"], count + 5);
  EXPECT_GT(witnesses["cards"].size(), 500u);
  EXPECT_EQ(witnesses["cards"][0]["id"], "many" + std::to_string(count - 1));
  EXPECT_EQ(occurrences(folder.read("witnesses.jsonl"), "\n"), count + 5u);
  EXPECT_THAT(folder.read("report.md"), HasSubstr("10 of " + std::to_string(count + 5)));
}

// A cell of the heat table links to a witness, so each place of a flip keeps one, however deep the others are.
TEST(Html, KeepsAWitnessOfEachPlaceOfAFlip) {
  Json record = stored_record();
  const Json deep = record["witnesses"][0];
  for (int i = 0; i < 3000; ++i) {
    Json witness = deep;
    witness["id"] = "deep" + std::to_string(i);
    witness["depth"] = 0.9;
    record["witnesses"].push_back(witness);
  }
  Json masked = deep;
  masked["id"] = "masked";
  masked["depth"] = nullptr;
  masked["flips"] = Json::array({{{"level", "comparison"},
                                  {"name", "edge_bc.side_a"},
                                  {"kind", "missed_separation"},
                                  {"decisive", false},
                                  {"links", {"rounding"}}}});
  record["witnesses"].push_back(masked);
  const TestFolder folder(record);
  render_reports(folder.path());
  const Json cards = page_data(folder.read("report.html"))["witnesses"]["cards"];
  EXPECT_EQ(cards.size(), 2000u);
  EXPECT_TRUE(std::any_of(cards.begin(), cards.end(), [](const Json& card) { return card["id"] == "masked"; }));
}

TEST(Html, WitnessHasDecimalsAndItsReplay) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const Json cards = page_data(folder.read("report.html"))["witnesses"]["cards"];
  EXPECT_EQ(cards[0]["id"], "w2");
  EXPECT_EQ(cards[0]["decimal"]["a"], Json::array({"1", "0", "-0.1"}));
  EXPECT_EQ(cards[0]["command"],
            "axiscert query '1:tangent:1:binary32:0:34' > witness.jsonl && "
            "axiscert check witness.jsonl --kernel published");
  EXPECT_EQ(cards[4]["id"], "w3");  // no depth: last
  EXPECT_THAT(cards[4]["command"].get<std::string>(), HasSubstr("' --mesh 'a|b.obj' > "));
  EXPECT_THAT(cards[2]["command"].get<std::string>(), HasSubstr("--kernel '<script>'"));
}

TEST(Markdown, EscapesNames) {
  const TestFolder folder(named("a|b`<script>\n# c"));
  render_reports(folder.path());
  std::string text = folder.read("report.md");
  EXPECT_THAT(text, HasSubstr("a\\|b\\`&lt;script> #<!-- --> c"));
  // Fenced commands show the name as it is.
  for (std::size_t open = text.find("```"); open != text.npos; open = text.find("```")) {
    text.erase(open, text.find("```", open + 3) + 3 - open);
  }
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_THAT(text, Not(HasSubstr("a|b")));
}

// Texts that a forge would interpret in a comment: mentions, issues, addresses, formulae, links, emphasis.
TEST(Markdown, NamesMentionAndLinkNothing) {
  EXPECT_EQ(plain("@octocat"), "@<!-- -->octocat");
  EXPECT_EQ(plain("org/repo#12"), "org/repo#<!-- -->12");
  EXPECT_EQ(plain("https://a.example www.b.example"), "https:<!-- -->//a.example w<!-- -->ww.b.example");
  EXPECT_EQ(plain("[a](b) ![c](d)"), "\\[a\\](b) !\\[c\\](d)");
  EXPECT_EQ(plain("_a_ edge_ab __b__ $x$"), "\\_a\\_ edge_ab \\_\\_b\\_\\_ \\$x\\$");
  EXPECT_EQ(plain("a\r\n<img src=x>&lt;"), "a  &lt;img src=x>&amp;lt;");
  const TestFolder folder(named("@octocat #1 https://a.example"));
  render_reports(folder.path());
  std::string text = folder.read("report.md");
  for (std::size_t open = text.find("```"); open != text.npos; open = text.find("```")) {
    text.erase(open, text.find("```", open + 3) + 3 - open);
  }
  for (const char* read : {"@octocat", "#1 ", "https://a"}) EXPECT_THAT(text, Not(HasSubstr(read)));
}

TEST(Markdown, StatesZeroWithItsLimitAndTheRequirement) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string text = folder.read("report.md");
  EXPECT_THAT(text, HasSubstr("0 (< 221,000 per million, 95 %)"));
  EXPECT_THAT(text, HasSubstr("for this generator only"));
  EXPECT_THAT(text, HasSubstr("**not met**"));
  EXPECT_THAT(text, HasSubstr("not exposed"));
  EXPECT_THAT(text, HasSubstr("NOT CHECKED"));
  EXPECT_THAT(text, HasSubstr("seed: 18446744073709551615"));
}

TEST(Markdown, StaysUnderAMebibyteAndSaysWhatItLeftOut) {
  Json record = stored_record();
  Json& families = record["kernels"][0]["families"];
  for (int i = 0; i < 600; ++i) {
    const std::string name = "family-" + std::string(80, 'x') + std::to_string(i);
    families[name] = families["tangent"];
    record["plan"]["families"].push_back(name);
  }
  const TestFolder folder(record);
  render_reports(folder.path());
  const std::string text = folder.read("report.md");
  EXPECT_LT(text.size(), std::size_t{1} << 20);
  EXPECT_THAT(text, HasSubstr("left out here"));
  EXPECT_THAT(text, HasSubstr("## How to reproduce"));
}

TEST(Markdown, IncompleteRunSaysSo) {
  Json record = stored_record();
  record["complete"] = false;
  const TestFolder folder(record);
  render_reports(folder.path());
  EXPECT_THAT(folder.read("report.md"), HasSubstr("INCOMPLETE"));
  EXPECT_EQ(page_data(folder.read("report.html"))["complete"], false);
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("interrupted"));
}

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
  EXPECT_THAT(text, HasSubstr("&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD&#10;"));
  EXPECT_EQ(text.find('\x01'), text.npos);
}

// Code scanning shows a message as text, another viewer may not: it is JSON either way, and reads back unchanged.
TEST(Sarif, NamesComeBackAndResultsStandAtTheirWitness) {
  const std::string evil = "</script><script>alert(1)</script>\"\n";
  const TestFolder folder(named(evil));
  render_reports(folder.path());
  const Json log = Json::parse(folder.read("report.sarif")), record = named(evil);
  bool is_named = false;
  for (const Json& result : log["runs"][0]["results"]) {
    const Json& place = result["locations"][0];
    is_named |= place["logicalLocations"][0]["fullyQualifiedName"].get<std::string>().starts_with(evil + "/binary32/");
    if (result["message"]["text"].get<std::string>().find("Reproduced by") == std::string::npos) continue;
    const std::size_t line = place["physicalLocation"]["region"]["startLine"];
    ASSERT_LE(line, record["witnesses"].size());
    EXPECT_NE(place["logicalLocations"][0]["fullyQualifiedName"].get<std::string>().find(
                  record["witnesses"][line - 1]["family"].get<std::string>()),
              std::string::npos);
  }
  EXPECT_TRUE(is_named);
}

// In plain text SARIF's viewers turn [text](target) into a link and fill in {0}.
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
  const Json record = stored_record();
  std::string text = ratchet_text(record);
  const std::string open = "EXPIRY OWNER REASON";
  text.replace(text.find(open), open.size(), "2030-01-01 mk \"as published\"");
  const auto at = text.find("deepest_false_separation=0.25");
  text.replace(at, 29, "deepest_false_separation=0.125");
  const Ratchet ratchet = parse_ratchet(text, "accepted.txt");
  const auto results = sarif_results(nullptr, outcome_json(ratchet, hold_against(ratchet, record, "2026-06-15")));
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

TEST(Witnesses, AreTheRecordsQueriesLineByLine) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  std::istringstream lines(folder.read("witnesses.jsonl"));
  std::string line;
  const Json record = stored_record();
  for (const Json& witness : record["witnesses"]) {
    ASSERT_TRUE(std::getline(lines, line));
    const Json query = Json::parse(line);
    EXPECT_EQ(query.size(), 7u);
    for (const auto& [member, value] : query.items()) EXPECT_EQ(value, witness[member]) << member;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace axiscert
