// The list of report formats: every one that is defined is in it, and all are written, the same bytes every time.
#include <algorithm>

#include "fuzz/text/json_form.h"
#include "kernel/sources_testing.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

TEST(Reports, EveryFormatThatIsDefinedIsListed) {
  constexpr const char* definition = R"re(extern const Format \w+_format = \{\s*"([^"]+)")re";
  for (const auto& [written, source] : testing_support::defined_in("reports", definition)) {
    EXPECT_TRUE(std::any_of(formats().begin(), formats().end(),
                            [&, &file = written](const Format* format) { return format->file == file; }))
        << source << " defines the format of " << written << ", which the list of reports/formats/format.cpp lacks";
  }
}

TEST(Reports, AllAreWritten) {
  const TestFolder folder(stored_record());
  folder.write("run.json", stored_run_info().dump());
  render_reports(folder.path());
  for (const Format* format : formats()) EXPECT_FALSE(folder.read(format->file).empty()) << format->file;
}

TEST(Reports, AreTheSameBytesEveryTime) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  const std::string html = folder.read("report.html"), markdown = folder.read("report.md");
  render_reports(folder.path());
  EXPECT_EQ(folder.read("report.html"), html);
  EXPECT_EQ(folder.read("report.md"), markdown);
}

}  // namespace

// Requirements, and how deep verdicts are wrong, in every format.

namespace {

using testing::HasSubstr;

// `<script>` shows verdicts alone, so that range is not checked: no format calls that met.
Json unchecked_record() {
  Json record = stored_record();
  record["plan"]["require"] = {"range", "depth=0.5"};
  Json& lattice = record["kernels"][1]["families"]["lattice"]["verdict"];
  for (const char* member : {"false_separation", "false_contact", "touching_flips", "invalid"}) lattice[member] = 0;
  lattice["decided_separations"] = 198;  // with the one that was called invalid
  lattice["decided"] = 498;
  for (Json* links : {&lattice["links"], &lattice["touching_links"]}) {
    for (Json& count : *links) count = 0;
  }
  lattice["first_by_link"]["unattributed"] = nullptr;
  record["kernels"][1]["families"]["lattice"]["classes"] = Json::object();
  return record;
}

TEST(Reports, EveryFormatSaysWhatIsNotChecked) {
  const TestFolder folder(unchecked_record());
  ASSERT_EQ(folder.rendering_error(), "");
  const std::string why = "the kernel shows verdicts alone", markdown = folder.read("report.md");
  EXPECT_THAT(markdown, HasSubstr("**The gate fails**"));
  EXPECT_THAT(markdown, HasSubstr("| range | &lt;script> | binary32 | **NOT CHECKED** | "));
  EXPECT_THAT(markdown, HasSubstr(" promised queries looked at, 2 declined: it decides "));
  EXPECT_THAT(markdown, HasSubstr(" % | " + why));
  EXPECT_THAT(markdown,
              HasSubstr("| depth=0.5 | &lt;script> | binary32 | met | 1,493 of 1,495 promised queries looked at, 2 "
                        "declined: it decides 99.8 % | covers 1,493 queries"));
  const std::string junit = folder.read("junit.xml");
  EXPECT_THAT(junit, HasSubstr("name=\"requirement range\" time=\"0\">\n      <failure type=\"not checked\""));
  const Json page = page_data(folder.read("report.html"))["requirement"];
  EXPECT_EQ(page["passes"], false);
  ASSERT_EQ(page["outcomes"].size(), 4u);
  EXPECT_EQ(page["outcomes"][1]["state"], "NOT CHECKED");
  EXPECT_EQ(page["outcomes"][3]["state"], "met");
  const Json sarif = Json::parse(folder.read("report.sarif"));
  const Json& last = sarif["runs"][0]["results"].back();
  EXPECT_EQ(last["ruleId"], "requirement-not-checked");
  EXPECT_EQ(last["level"], "error");
  EXPECT_EQ(sarif["runs"][0]["tool"]["driver"]["rules"][last["ruleIndex"].get<std::size_t>()]["id"], last["ruleId"]);
}

TEST(Reports, WhatMayBeLeftUncheckedIsNotCalledMet) {
  Json record = unchecked_record();
  record["kernels"].erase(0);
  record["plan"]["kernels"].erase(0);
  record["witnesses"] = Json::array();
  record["plan"]["allow_unchecked"] = {"range"};
  const TestFolder folder(record);
  ASSERT_EQ(folder.rendering_error(), "");
  EXPECT_THAT(folder.read("report.md"), HasSubstr("The gate passes."));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("| NOT CHECKED, which is allowed |"));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("--require range --require depth=0.5 --allow-unchecked range"));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("name=\"requirement range\" time=\"0\">\n      <skipped"));
  const Json sarif = Json::parse(folder.read("report.sarif"));
  std::size_t suppressed = 0;
  for (const Json& result : sarif["runs"][0]["results"])
    suppressed += result.value("suppressions", Json::array()).size();
  EXPECT_EQ(suppressed, 1u);
}

TEST(Junit, AFamilyOnWhichALevelCannotBeSeenIsSkipped) {
  Json record = unchecked_record();
  record["plan"]["require"] = "logic";
  const TestFolder folder(record);
  ASSERT_EQ(folder.rendering_error(), "");
  const std::string junit = folder.read("junit.xml");
  const std::size_t suite = junit.find("testsuite name=\"&lt;script&gt;");
  EXPECT_THAT(junit.substr(suite), HasSubstr("name=\"tangent verdict\" time=\"0\">\n      <skipped message=\"NOT "
                                             "CHECKED: logic: this kernel's answers here cannot show it"));
  EXPECT_THAT(junit.substr(suite), HasSubstr("name=\"lattice verdict\" time=\"0\"/>"));
}

// The depths of a record that has them: every format shows them.
TEST(Reports, EveryFormatHasTheDepths) {
  Json record = stored_record();
  Json& verdict = tangent_counts(record)["verdict"];
  const auto depths = [](const Json& counts) {
    Json all = json_of(DepthTally());
    all.update(counts);
    return all;
  };
  verdict["depths"] = depths(
      {{"false_separation", {{"zero", 3}, {"-12", 30}, {"-1", 7}}}, {"false_contact", {{"-7", 20}}}, {"deep", 7}});
  verdict["engine_like"] = {{"queries", 600},
                            {"decided_contacts", 360},
                            {"decided_separations", 240},
                            {"decided", 600},
                            {"false_separation", 7},
                            {"false_contact", 0},
                            {"depths", depths({{"false_separation", {{"-1", 7}}}, {"deep", 7}})}};
  const TestFolder folder(record);
  ASSERT_EQ(folder.rendering_error(), "");
  EXPECT_THAT(folder.read("report.md"),
              HasSubstr("| published | binary32 | tangent | missed | 3 | 30 | 0 | 0 | 0 | 0 | 0 | 0 | 0 | 7 |"));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("7 missed and 0 phantom contacts on 600 engine-like queries"));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("2 missed contacts for each phantom one"));
  EXPECT_THAT(folder.read("report.sarif"), HasSubstr("By depth, of the scene: zero: 3, < 1e-8: 30, 0.1: 7."));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("&quot;-12&quot;:30"));
  const Json kernel = page_data(folder.read("report.html"))["kernels"][0];
  EXPECT_EQ(kernel["depths"]["false_contact"][3], 20);
  EXPECT_EQ(kernel["depths"]["columns"][3], "1e-7");
}

}  // namespace

}  // namespace axiscert
