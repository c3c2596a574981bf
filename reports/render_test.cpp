// What the reports say, and that no name in a record becomes markup.
#include "reports/test_run.h"

#include "reports/requirement.h"

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

TEST(Reports, AllFourAreWritten) {
  const TestFolder folder(stored_record());
  folder.write("run.json", stored_run_info().dump());
  render_reports(folder.path());
  for (const char* file : {"report.html", "report.md", "junit.xml", "witnesses.jsonl"}) {
    EXPECT_FALSE(folder.read(file).empty()) << file;
  }
}

TEST(Reports, AreTheSameBytesEveryTime) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string html = folder.read("report.html"), markdown = folder.read("report.md");
  render_reports(folder.path());
  EXPECT_EQ(folder.read("report.html"), html);
  EXPECT_EQ(folder.read("report.md"), markdown);
}

TEST(Html, NamesInTheDataAreInert) {
  const std::string evil = "</script><script>alert(1)</script><!--/*JS*/&\xE2\x80\xA8\xE2\x80\xA9";
  const TestFolder folder(named(evil)), plain(stored_record());
  render_reports(folder.path());
  render_reports(plain.path());
  const std::string html = folder.read("report.html");
  EXPECT_EQ(occurrences(html, "<script"), occurrences(plain.read("report.html"), "<script"));
  EXPECT_EQ(occurrences(html, "</script"), 2u);
  EXPECT_THAT(html, Not(HasSubstr("<!--")));
  EXPECT_THAT(html, Not(HasSubstr("\xE2\x80\xA8")));
  EXPECT_EQ(page_data(html)["kernels"][1]["id"], evil);
}

TEST(Html, AsksNothingOfTheNetwork) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string html = folder.read("report.html");
  for (const char* word : {"http://", "https://", "src=", "@import", "url(", "fetch("}) {
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

TEST(Html, ShowsTheDeepest200WitnessesAndCountsAll) {
  Json record = stored_record();
  for (int i = 0; i < 300; ++i) {
    Json witness = record["witnesses"][0];
    witness["id"] = "many" + std::to_string(i);
    witness["depth"] = 0.001 * i;
    record["witnesses"].push_back(witness);
  }
  const TestFolder folder(record);
  render_reports(folder.path());
  const Json witnesses = page_data(folder.read("report.html"))["witnesses"];
  EXPECT_EQ(witnesses["total"], 305);
  ASSERT_EQ(witnesses["cards"].size(), 200u);
  EXPECT_EQ(witnesses["cards"][0]["id"], "many299");
  EXPECT_EQ(occurrences(folder.read("witnesses.jsonl"), "\n"), 305u);
  EXPECT_THAT(folder.read("report.md"), HasSubstr("10 of 305"));
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
  EXPECT_THAT(text, HasSubstr("a\\|b\\`&lt;script> \\# c"));
  // Fenced commands show the name as it is.
  for (std::size_t open = text.find("```"); open != text.npos; open = text.find("```")) {
    text.erase(open, text.find("```", open + 3) + 3 - open);
  }
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_THAT(text, Not(HasSubstr("a|b")));
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
  for (int i = 0; i < 1500; ++i) {
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
  // published: tangent's verdict and plane.radius; <script>: lattice's verdict. Skipped: its comparisons, which it does
  // not show, and its mesh, which it did not meet.
  EXPECT_THAT(text, HasSubstr("<testsuites name=\"axiscert\" tests=\"11\" failures=\"3\" errors=\"0\" skipped=\"3\">"));
  EXPECT_THAT(text, HasSubstr("name=\"tangent plane.radius\""));
  EXPECT_THAT(text, HasSubstr("3 errors above 2 u; the smallest tolerance that passes is 3.5 u"));
}

TEST(Junit, WithoutARequirementVerdictsAreSkippedNotPassed) {
  Json record = stored_record();
  record["plan"]["require"] = nullptr;
  record["plan"]["tolerance"] = Json::object();
  const TestFolder folder(record);
  render_reports(folder.path());
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("tests=\"6\" failures=\"0\" errors=\"0\" skipped=\"6\""));
}

TEST(Junit, EscapesNamesAndControlCharacters) {
  const TestFolder folder(named(std::string("<a & \"b\">\x01\x1b\xEF\xBF\xBF\n")));
  render_reports(folder.path());
  const std::string text = folder.read("junit.xml");
  EXPECT_THAT(text, HasSubstr("&lt;a &amp; &quot;b&quot;&gt;\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD&#10;"));
  EXPECT_EQ(text.find('\x01'), text.npos);
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
