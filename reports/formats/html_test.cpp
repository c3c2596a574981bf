// The contents of report.html; no name in a record may become markup.
#include "fuzz/text/json_form.h"
#include "reports/testing/test_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "reports/page/page_template.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(Html, NamesInTheDataAreInert) {
  const std::string evil = "</script><script>alert(1)</script><!--/*JS*/&\xE2\x80\xA8\xE2\x80\xA9";
  const TestFolder folder(named(evil)), harmless(stored_record());
  render_reports(folder.path());
  render_reports(harmless.path());
  const std::string html = folder.read("report.html");
  EXPECT_EQ(occurrences(html, "<script"), occurrences(harmless.read("report.html"), "<script"));
  EXPECT_EQ(occurrences(html, "</script"), 3u);
  EXPECT_THAT(html, Not(HasSubstr("alert(1)")));
  EXPECT_THAT(html, Not(HasSubstr("<!--")));
  EXPECT_EQ(page_data(html)["kernels"][1]["id"], printable_line(evil));
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
  EXPECT_EQ(data["requirement"]["failures"].size(), unmet(read_as<Record>(stored_record()), "logic").size());
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
  // The shortest of each cause, then the deepest.
  EXPECT_THAT(witnesses["cards"][0]["id"].get<std::string>(), StartsWith("many"));
  std::vector<std::string> first;
  for (std::size_t i = 0; i < 10; ++i) first.push_back(witnesses["cards"][i]["id"]);
  EXPECT_THAT(first, testing::Contains("many" + std::to_string(count - 1)));
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

// The page draws and names by the predicate: the axis of each comparison, the first contact, the time that was
// reported.
TEST(Html, AMotionHasItsPredicateAndItsFirstContact) {
  const TestFolder folder(grown(motions(contacts(9, 0.25, 0))));
  ASSERT_EQ(folder.rendering_error(), "");
  const Json data = page_data(folder.read("report.html")), card = data["witnesses"]["cards"][0];
  EXPECT_EQ(data["comparisons"]["start.vertex_a.side_b"], "start.vertex_a");
  EXPECT_EQ(data["comparisons"].size(), 61u);
  EXPECT_EQ(card["predicate"], "moving-sphere");
  EXPECT_EQ(card["exact_contact"]["time"], "0x1p-2");
  EXPECT_EQ(card["measures"]["time"], "late");
  EXPECT_EQ(card["decimal"]["d"], Json::array({"2", "0", "0"}));
  const TestFolder first(stored_record());
  render_reports(first.path());
  const Json other = page_data(first.read("report.html"));
  EXPECT_FALSE(other["witnesses"]["cards"][0].contains("predicate"));
  EXPECT_EQ(other["comparisons"]["edge_ab.side_c"], "edge_ab");
}

}  // namespace
}  // namespace axiscert
