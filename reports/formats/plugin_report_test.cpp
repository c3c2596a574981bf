// Plug-ins from the campaign to the reports: findings, missing answers, conventions and limits as people read them.
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "reports/wording/evidence.h"
#include "reports/wording/depths.h"
#include "reports/wording/summary.h"
#include "reports/wording/reproduce.h"
#include "reports/gates/requirement.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string evil = "<b>|`]]>&\"";

// In each batch of 1024: no answer to the fourth query, and a write next to an array at the first.
void misbehaves(const Query<double>&, std::size_t i, Verdict& verdict, std::vector<Finding>& findings) {
  if (i == 0) findings.push_back({FindingKind::out_of_bounds, i, "wrote beside lhs, " + evil});
  if (i != 3) return;
  verdict = Verdict::unanswered;
  findings.push_back({FindingKind::crash, i, "signal 11 (SIGSEGV)"});
}
void no_fault(const Query<double>&, std::size_t, Verdict&, std::vector<Finding>&) {}

Record record_with(std::vector<const Kernel*> kernels, const std::vector<std::string>& families, std::uint64_t trials,
                   const std::string& require = "") {
  Plan plan;
  plan.answerers.kernels = std::move(kernels);
  for (const std::string& name : families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [trials](const Source&, Precision) { return trials; };
  plan.running.target = std::string(scalar_target);
  plan.answerers.plugins = {{.name = "mine.so", .kind = "plugin", .sha256 = std::string(64, 'a')},
                            {.name = "gone.so", .kind = "plugin"}};
  const std::atomic<bool> never = false;
  const Record record = record_of(plan, run_campaign(plan, never, [](const Progress&) {}),
                                  require.empty() ? RunRequirements{} : RunRequirements{{require}, {}});
  return read_record(json_of(record), "record.json");
}

// A plug-in that misbehaves, one that was not loaded, and one that is only limited.
Record plugin_record(const std::string& require = "") {
  const Kernel bad = supervised_kernel("plugin:mine.so", misbehaves);
  const Kernel gone = unloadable_kernel("plugin:gone.so", "no such file, " + evil);
  Kernel limited = black_box("plugin:box.so", no_fault);
  limited.limits = {.greatest_coordinate = 0x1p10, .least_area = 0.125};
  limited.touching = TouchingPolicy::either;
  return record_with({&bad, &gone, &limited}, {"general", "scale"}, 2048, require);
}

std::vector<std::string> unmet_texts(const Record& record, const std::string& level) {
  std::vector<std::string> lines;
  for (const Failure& failure : unmet(record, level)) lines.push_back(failure.text());
  return lines;
}

TEST(PluginRecord, HasEachFindingWithItsFirstQuery) {
  const Record record = plugin_record();
  const std::vector<FindingRecord>& findings = record.findings;
  ASSERT_EQ(findings.size(), 5u);  // two on each family, and one made in loading
  EXPECT_EQ(findings[0].kind, FindingKind::crash);
  EXPECT_EQ(findings[0].family, "general");
  EXPECT_EQ(findings[0].count, 2u);
  EXPECT_EQ(findings[0].address, "1:general:2:binary32:0:3");
  EXPECT_EQ(findings[0].numbers.at("a").value().numbers.size(), 3u);
  EXPECT_EQ(findings[1].kind, FindingKind::out_of_bounds);
  EXPECT_EQ(findings[4].kernel, "plugin:gone.so");
  EXPECT_FALSE(findings[4].precision || findings[4].family || findings[4].address);
  for (const char* group : {"a", "r"}) EXPECT_FALSE(findings[4].numbers.at(group));
  EXPECT_EQ(not_judged(record), std::vector<std::string>{"plugin:gone.so"});
  EXPECT_EQ(record.kernels[0].families.at("general").verdict.unanswered, 2u);
}

TEST(PluginRecord, SaysWhatEachKernelClaims) {
  const Record record = plugin_record();
  const KernelRecord &bad = record.kernels[0], &limited = record.kernels[1];
  EXPECT_EQ(bad.reference, false);
  EXPECT_FALSE(bad.limits);
  EXPECT_FALSE(bad.families.at("scale").verdict.outside_limits);
  EXPECT_FALSE(limited.reference);
  EXPECT_EQ(limited.touching, TouchingPolicy::either);
  EXPECT_EQ(limited.limits.value().least_area, 0.125);
  EXPECT_FALSE(limited.limits->least_radius);
  EXPECT_GT(limited.families.at("scale").verdict.outside_limits.value().trials, 0u);
  EXPECT_FALSE(limited.families.at("scale").comparisons) << "it shows only verdicts";
  EXPECT_TRUE(bad.families.at("general").axes.value().contains("plane"));
  EXPECT_EQ(record.plan.files[0].sha256, std::string(64, 'a'));
  EXPECT_FALSE(record.plan.files[1].sha256);
}

TEST(PluginRecord, OfNothingButAKernelThatCouldNotBeLoaded) {
  const Kernel gone = unloadable_kernel("plugin:gone.so", "no such file");
  const Record record = record_with({&gone}, {"general"}, 10, "logic");
  EXPECT_TRUE(record.kernels.empty());
  for (const char* level : {"logic", "range", "exact", "conservative", "conservative=1"}) {
    EXPECT_EQ(unmet_texts(record, level), std::vector<std::string>{"plugin:gone.so: load: no such file"}) << level;
  }
  const TestFolder folder(json_of(record));
  render_reports(folder.path());
  EXPECT_THAT(folder.read("report.md"), HasSubstr("plugin:gone.so: NOT JUDGED: it could not be loaded"));
  EXPECT_THAT(folder.read("junit.xml"), HasSubstr("tests=\"1\" failures=\"1\""));
}

TEST(PluginRequirement, NoLevelIsMetWithAFindingOrWithoutAnAnswer) {
  const Record record = plugin_record();
  for (const char* level : {"logic", "range", "exact", "conservative"}) {
    const auto texts = unmet_texts(record, level);
    EXPECT_THAT(texts, testing::Contains("plugin:gone.so: load: no such file, " + evil)) << level;
    EXPECT_THAT(texts, testing::Contains(HasSubstr("on general: crash: signal 11 (SIGSEGV): 2"))) << level;
    EXPECT_THAT(texts, testing::Contains(HasSubstr("on general: valid queries without an answer: 2"))) << level;
  }
}

TEST(PluginRequirement, ASearchWithoutAnAnswerCountsToo) {
  const Kernel kernel = black_box("plugin:mine.so", [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (q.r > 0x1p100) verdict = Verdict::unanswered;
  });
  EXPECT_THAT(unmet_texts(record_with({&kernel}, {"general"}, 512), "conservative"),
              testing::ElementsAre(HasSubstr("searches for a critical radius without an answer: 2")));
}

TEST(PluginRequirement, WhatIsOutsideTheLimitsIsNoRequirement) {
  const auto wrong_outside = [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (std::abs(q.a.x) > 0x1p10) verdict = Verdict::unanswered;
    else if (std::abs(q.p.x) > 0x1p10) verdict = Verdict::separated;
  };
  Kernel kernel = black_box("plugin:mine.so", wrong_outside);
  EXPECT_FALSE(unmet(record_with({&kernel}, {"scale"}, 1000), "conservative").empty());
  kernel.limits = {.least_coordinate = 0x1p-10, .greatest_coordinate = 0x1p10};
  const Record record = record_with({&kernel}, {"scale"}, 1000);
  EXPECT_TRUE(unmet(record, "conservative").empty());
  EXPECT_GT(record.kernels[0].families.at("scale").verdict.outside_limits->unanswered, 0u);
}

// A kernel that says contact too late misses contacts, one that says it too early invents them.
TEST(PluginRecord, SaysToWhichSideAKernelErrs) {
  for (const double factor : {0.99, 1.01}) {
    const Kernel kernel = black_box("plugin:mine.so", [factor](const Query<double>& q, auto, Verdict& verdict, auto&) {
      Query<double> other = q;
      other.r *= factor;
      if (is_valid(q)) verdict = distance_order(other) > 0 ? Verdict::separated : Verdict::contact;
    });
    const Record record = record_with({&kernel}, {"general"}, 2048);
    const FamilyRecord& family = record.kernels[0].families.at("general");
    const CriticalRadiusRecord& radius = family.critical_radius;
    const bool is_late = factor < 1;
    EXPECT_EQ(is_late ? radius.late : radius.early, radius.sampled);
    EXPECT_EQ(is_late ? radius.early : radius.late, 0u);
    EXPECT_EQ(radius.signed_median_ulps.value().value > 0, is_late);
    EXPECT_THAT(bias_text(record.kernels[0], family),
                HasSubstr(is_late ? "missed contacts alone; critical radius early on 0, late on 8"
                                  : "phantom contacts alone; critical radius early on 8, late on 0"));
    EXPECT_THAT(engine_text(family), HasSubstr(" on 2,048 engine-like queries"));
    const EngineTally& engine = family.verdict.engine.value();
    EXPECT_GT(is_late ? engine.false_separation() : engine.false_contact(), 0u);
  }
}

TEST(PluginReports, WithoutADecidedContactNothingIsSaidOfMissedOnes) {
  Kernel kernel = black_box("plugin:mine.so", [](const Query<double>&, auto, Verdict& verdict, auto&) {
    if (verdict == Verdict::contact) verdict = Verdict::undecided;
  });
  kernel.may_decline = true;
  const TestFolder folder(json_of(record_with({&kernel}, {"general"}, 512)));
  render_reports(folder.path());
  EXPECT_THAT(folder.read("report.md"), HasSubstr("| not checked | - | 0 (< "));
  const Json shown = page_data(folder.read("report.html"))["kernels"][0];
  EXPECT_TRUE(shown["all"]["zero_limits"]["false_separation"].is_null());
  EXPECT_EQ(shown["decided"], shown["all"]["truth"]["separated"]);
  EXPECT_THAT(shown["sentences"][0].get<std::string>(), testing::ContainsRegex("; 0 of [0-9]+ contacts decided$"));
}

TEST(PluginReports, WithoutAVerdictNothingIsSaidOfLinksAndImages) {
  Kernel kernel = black_box("plugin:mine.so",
                            [](const Query<double>&, auto, Verdict& verdict, auto&) { verdict = Verdict::undecided; });
  kernel.may_decline = true;
  const TestFolder folder(json_of(record_with({&kernel}, {"orders"}, 512)));
  render_reports(folder.path());
  EXPECT_THAT(folder.read("report.md"), HasSubstr("No query was decided: no link could break."));
  EXPECT_THAT(folder.read("report.md"), HasSubstr("| orders | - | 0 | - | - |"));
  EXPECT_EQ(page_data(folder.read("report.html"))["kernels"][0]["all"]["verdict"]["engine_like"]["decided"], 0);
}

// Right formulae in another order, or fused: what they round is not a fault of logic. A slip in them is one, and so is
// a wrong answer where nothing rounds.
TEST(PluginRequirement, LogicOfFormulaeInAnOrderOfTheirOwn) {
  const std::vector<std::string> families = {"tangent", "sliver", "lattice", "scale"};
  const Kernel fused = supervised_kernel("fused", no_fault, "reduced-nonstrict+fma");
  const Record right = record_with({&fused}, families, 1000);
  for (const char* family : {"tangent", "scale"})
    EXPECT_GT(right.kernels[0].families.at(family).verdict.links[Link::unattributed], 0u);
  EXPECT_TRUE(unmet(right, "logic").empty());
  EXPECT_TRUE(unmet(right, "range").empty());

  const Kernel slip = supervised_kernel("slip", no_fault, "vertex-typo");
  EXPECT_THAT(unmet_texts(record_with({&slip}, {"tangent"}, 1000), "logic"),
              testing::Contains(HasSubstr("broken specification link")));

  const auto wrong_often = [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (q.a.x == 1) verdict = Verdict::contact;
  };
  const Kernel wrong = supervised_kernel("wrong", wrong_often, "reduced-nonstrict");
  EXPECT_THAT(unmet_texts(record_with({&wrong}, families, 1000), "range"),
              testing::ElementsAre(AllOf(HasSubstr("wrong binary32 on lattice"), HasSubstr("its formulae do not give"),
                                         HasSubstr("witness"))));

  const auto touching_wrong = [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (is_valid(q) && distance_order(q) == 0) verdict = Verdict::separated;
  };
  const Kernel another = supervised_kernel("touching", touching_wrong, "reduced-nonstrict");
  const Record record = record_with({&another}, {"lattice"}, 1000);
  EXPECT_GT(record.kernels[0].families.at("lattice").verdict.touching_flips, 0u);
  EXPECT_TRUE(unmet(record, "logic").empty()) << "touching spheres are not counted";
}

TEST(PluginReports, FindingsStandFirstWithTheirReplay) {
  const TestFolder folder(json_of(plugin_record("logic")));
  render_reports(folder.path());
  const std::string markdown = folder.read("report.md");
  EXPECT_LT(markdown.find("## Findings"), markdown.find("## Summary"));
  EXPECT_THAT(markdown, HasSubstr("plugin:mine.so binary32: crash on family general, 2 times, first at "
                                  "1:general:2:binary32:0:3: signal 11 (SIGSEGV); also on family scale (2 times)"));
  EXPECT_THAT(markdown, HasSubstr("axiscert query '1:general:2:binary32:0:3' > witness.jsonl && axiscert check "
                                  "witness.jsonl --kernel plugin:mine.so"));
  EXPECT_THAT(markdown, HasSubstr("> **plugin:gone.so: NOT JUDGED: it could not be loaded"));
  EXPECT_THAT(markdown, HasSubstr("| plugin:gone.so |  | **not judged** |"));
  EXPECT_THAT(markdown, Not(HasSubstr("<b>")));
  EXPECT_THAT(markdown, HasSubstr("|coordinates| to 1024, area from 0.125"));
  EXPECT_THAT(markdown, HasSubstr("## Outside the limits"));
  EXPECT_THAT(markdown, HasSubstr("gone.so, which could not be read"));
}

TEST(PluginReports, EachFindingIsAFailedCase) {
  const TestFolder folder(json_of(plugin_record()));  // no requirement: a finding fails all the same
  render_reports(folder.path());
  const std::string junit = folder.read("junit.xml");
  EXPECT_EQ(occurrences(junit, "<failure "), 5u);
  EXPECT_THAT(junit, HasSubstr("<testsuite name=\"plugin:gone.so\" tests=\"1\" failures=\"1\""));
  EXPECT_THAT(junit, HasSubstr("name=\"general crash\""));
  EXPECT_THAT(junit, Not(HasSubstr("<b>")));
}

TEST(PluginReports, ThePageHasThemAsData) {
  const TestFolder folder(json_of(plugin_record("logic")));
  render_reports(folder.path());
  const Json data = page_data(folder.read("report.html"));
  ASSERT_EQ(data["findings"].size(), 3u);  // each kind once, with the families on which it showed
  EXPECT_EQ(data["findings"][0]["others"], "also on family scale (2 times)");
  EXPECT_THAT(data["findings"][0]["command"].get<std::string>(), HasSubstr("--kernel plugin:mine.so"));
  EXPECT_EQ(data["findings"][2]["command"], "");
  EXPECT_EQ(data["not_judged"], Json::array({"plugin:gone.so"}));
  EXPECT_EQ(data["kernels"][1]["touching_text"], "a touching sphere may be called either");
  EXPECT_GT(data["kernels"][1]["all"]["verdict"]["outside_limits"]["trials"], 0);
  EXPECT_FALSE(data["kernels"][0]["all"]["verdict"].contains("first_by_link"));
}

TEST(PluginReports, ARateIsOfQueriesWithinTheLimits) {
  const KernelRecord kernel = read_as<KernelRecord>(stored_record()["kernels"][0]);
  FamilyRecord family = kernel.families.at("lattice");
  EXPECT_EQ(per_million(1, family), 2000);
  OutsideTally& outside = family.verdict.outside_limits.emplace();
  outside.trials = 400;
  outside.contact = 240;
  outside.touching = 48;
  EXPECT_EQ(per_million(1, family), 10000);
  EXPECT_GT(zero_limit_per_million(kernel, family), 29000) << "100 queries, not 500";
  family.verdict.undecided = 100;
  EXPECT_LT(zero_limit_per_million(kernel, family), 0) << "none of them was decided";
}

TEST(PluginFolder, FindingsThatContradictTheRecordAreRefused) {
  const Json record = json_of(plugin_record());
  const auto error_after = [&](const std::function<void(Json&)>& edit) {
    Json edited = record;
    edit(edited);
    const TestFolder folder(edited);
    return folder.rendering_error();
  };
  EXPECT_EQ(error_after([](Json&) {}), "");
  const auto verdict = [](Json& r) -> Json& { return r["kernels"][1]["families"]["scale"]["verdict"]; };
  EXPECT_THAT(error_after([](Json& r) { r["findings"].push_back(r["findings"][0]); }), HasSubstr("twice"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"][0]["family"] = "nosuch"; }), HasSubstr("not in the record"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"][0]["address"] = nullptr; }), HasSubstr("go together"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"][0]["count"] = 0; }), HasSubstr("count of zero"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"][0]["kind"] = "rude"; }), HasSubstr("/findings/0/kind"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"].erase(4); }), HasSubstr("plugin:gone.so"));
  EXPECT_THAT(error_after([](Json& r) { r["findings"][4]["kernel"] = "other"; }), HasSubstr("gone.so"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["outside_limits"] = nullptr; }), HasSubstr("declares limits"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["outside_limits"]["trials"] = 2049; }), HasSubstr("outside"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["unanswered"] = 2049; }), HasSubstr("unanswered"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["first_by_link"]["range"] = 7; }), HasSubstr("first_by_link"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["touching_links"]["range"] = 7; }), HasSubstr("touching"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["depths"]["false_contact"]["-1"] = 9999; }), HasSubstr("add up"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["engine_like"]["queries"] = 2049; }), HasSubstr("engine-like"));
  EXPECT_THAT(error_after([&](Json& r) { verdict(r)["depths"]["false_contact"]["-21"] = 1; }), HasSubstr("-21"));
  EXPECT_THAT(error_after([](Json& r) { r["kernels"][1]["reference"] = true; }), HasSubstr("reference"));
}

}  // namespace
}  // namespace axiscert
