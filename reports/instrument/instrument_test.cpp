// The text and the page of an instrument's report.
#include "fuzz/text/json_form.h"
#include "reports/instrument/instrument.h"
#include "reports/instrument/figures.h"

#include <gtest/gtest.h>

namespace axiscert {
namespace {

InstrumentReport hostile_report() {
  InstrumentReport report;
  report.name = "ladder";
  report.title = "A <title> & more";
  report.command = "axiscert ladder --kernel '</script>'";
  report.notes = {"In ulps; </section> is text."};
  report.tables = {{"Errors <u>", {"kernel", "error"}, {{"published", "1.5"}, {"/*JS*/", "-12.25"}}}};
  InstrumentPlot plot;
  plot.caption = "A plot";
  plot.x_label = "p";
  plot.y_label = "flips";
  plot.series = {{"</script><script>alert(1)", {{1, 2}, {3, 4}}, {}}};
  report.plots = {plot};
  InstrumentScene scene;
  scene.title = "peer <b>";
  scene.sentence = "It misses.";
  scene.code = "ask('</script>');\nend();\n";
  scene.needs = "package 1.0";
  scene.query = {{"r", "</script>"}};
  report.tables[0].scenes = {scene};
  return report;
}

TEST(InstrumentText, AlignsNumbersRightAndNamesLeft) {
  EXPECT_NE(instrument_text(hostile_report()).find("  published     1.5\n  /*JS*/     -12.25\n"), std::string::npos)
      << instrument_text(hostile_report());
}

TEST(InstrumentText, HasTheCodeOfScenesBelowTheTables) {
  EXPECT_NE(instrument_text(hostile_report())
                .find("-12.25\n\npeer <b>: It misses. With package 1.0:\n    ask('</script>');\n    end();\n\nIn ulps"),
            std::string::npos)
      << instrument_text(hostile_report());
}

TEST(InstrumentPage, HasAPlaceForThePictureOfAScene) {
  const std::string page = instrument_page(hostile_report());
  EXPECT_NE(page.find("<h3>peer &lt;b&gt;</h3>"), std::string::npos);
  EXPECT_NE(page.find("<div class=\"picture\"></div>"), std::string::npos);
  EXPECT_NE(page.find("<code>ask('&lt;/script&gt;');\nend();\n</code>"), std::string::npos);
  EXPECT_NE(page.find("id=\"scenes\" type=\"application/json\">[{\"r\":\"\\u003c/script\\u003e\"}]<"),
            std::string::npos);
}

TEST(InstrumentPage, HasTheIntervalsOfPointsAsFiguresAndForTheErrorBars) {
  InstrumentReport report = hostile_report();
  EXPECT_NE(instrument_page(report).find("\"intervals\":[]"), std::string::npos) << "none, and no bars";
  EXPECT_EQ(instrument_page(report).find("<th>from</th>"), std::string::npos);
  report.plots[0].series[0].intervals = {{1.5, 2.5}, {3, 5.25}};
  const std::string page = instrument_page(report);
  EXPECT_NE(page.find("<td class=\"n\">4</td><td class=\"n\">3</td><td class=\"n\">5.25</td>"), std::string::npos);
  EXPECT_NE(page.find("\"intervals\":[[1.5,2.5],[3.0,5.25]]"), std::string::npos);
}

TEST(InstrumentPage, KeepsWhatItIsGivenAsText) {
  const std::string page = instrument_page(hostile_report());
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<title>A <title>"), std::string::npos);
  EXPECT_NE(page.find("<h1>A &lt;title&gt; &amp; more</h1>"), std::string::npos);
  EXPECT_NE(page.find("<th>/*JS*/</th><td class=\"n\">-12.25</td>"), std::string::npos);
  EXPECT_NE(page.find("drawPlots();"), std::string::npos) << "the script is in its own place";
}

TEST(InstrumentPage, BeginsWithTheAnswerAndEndsWithWords) {
  InstrumentReport report = hostile_report();
  InstrumentScene scene;
  scene.title = "first";
  scene.query = {{"r", "0x1p+0"}};
  report.first = {{"The answer", {"level"}, {{"met"}}}, scene, {"All is well."}};
  report.are_notes_last = true;
  report.tables.push_back({"Made from", {"what"}, {{"<x>"}}});
  report.tables.back().is_folded = true;
  const std::string page = instrument_page(report);
  std::size_t at = 0;
  for (const char* part :
       {"<section id=\"answer\"><h2>The answer</h2>", "<li>All is well.</li>", "<th>met</th>", "<h3>first</h3>",
        "<h2>Errors &lt;u&gt;</h2>", "<details><summary><h2>Made from</h2></summary>",
        "<section id=\"words\"><details>", "In ulps; &lt;/section&gt; is text."}) {
    const std::size_t found = page.find(part, at);
    ASSERT_NE(found, page.npos) << part;
    at = found;
  }
  EXPECT_NE(page.find("id=\"scenes\" type=\"application/json\">[{\"r\":\"0x1p+0\"},{\"r\""), page.npos)
      << "pictures are in the order of the page";
}

TEST(InstrumentPage, BeginsWithWhatWasAskedWhereThereIsNoAnswer) {
  InstrumentReport report = hostile_report();
  report.notes = {"256 queries.", "A window is an interval."};
  const std::string page = instrument_page(report);
  EXPECT_LT(page.find("<p class=\"lead\">256 queries.</p>"), page.find("<h2>Errors &lt;u&gt;</h2>"));
  EXPECT_GT(page.find("A window is an interval."), page.find("<section id=\"words\"><details>"));
}

TEST(InstrumentPage, SaysOfEachCellOfTheAnswerWhatItIs) {
  InstrumentReport report;
  report.first = {{"The answer", {"level", "binary32"}, {{"exact", "not met"}}}, {}, {}};
  EXPECT_NE(instrument_page(report).find("<th>exact</th><td class=\"bad\" data-label=\"binary32\">not met</td>"),
            std::string::npos);
}

// No table is wider than a page: its columns are in one for each heading, and those that every one has come first.
TEST(InstrumentPage, HasATableForEachHeading) {
  InstrumentReport report;
  InstrumentTable table{"By family", {"kernel"}, {{"k"}}};
  table.headings = {"Everyday", "Own", "Hard"};
  table.heading_of = {0};
  for (int i = 0; i < 13; ++i) {
    table.columns.push_back("f" + std::to_string(i));
    table.rows[0].push_back("c" + std::to_string(i));
    table.heading_of.push_back(i == 12 ? 1 : 3);
  }
  report.tables = {table};
  const std::string page = instrument_page(report);
  const auto row = [&](const std::string& cells) { return page.find("<tr><th>k</th>" + cells + "</tr>"); };
  ASSERT_NE(row("<td>c12</td>"), page.npos);
  EXPECT_LT(page.find("<h3>Everyday</h3>"), row("<td>c12</td>"));
  EXPECT_EQ(page.find("<h3>Own</h3>"), page.npos);
  EXPECT_NE(row("<td>c10</td><td>c11</td>"), page.npos) << "ten columns are as many as fit";
}

TEST(InstrumentPage, NeedsNothingFromANetwork) {
  const std::string page = instrument_page(hostile_report());
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
}

TEST(LookedAtText, NamesEverythingThatShowsNothing) {
  LookedAt looked_at;
  looked_at.decided = 1234;
  EXPECT_EQ(looked_at_text(looked_at, false), "1,234 of 1,234 decided");
  EXPECT_EQ(faults_text(looked_at, false), "");
  looked_at.undecided = 5;
  looked_at.invalid = 4;
  looked_at.unanswered = 3;
  looked_at.outside_limits = 2;
  looked_at.no_query = 1;
  EXPECT_EQ(looked_at_text(looked_at, true),
            "1,234 of 1,249 decided, 5 declined, 4 called invalid, 3 without an answer, 2 outside its limits, 1 not "
            "valid");
  EXPECT_EQ(not_decided_text(looked_at, false).substr(0, 49), "5 declined, which it does not declare that it may");
  EXPECT_EQ(faults_text(looked_at, true), "Fault: no verdict on 7 valid queries within its limits.");
  EXPECT_EQ(faults_text(looked_at, false), "Fault: no verdict on 12 valid queries within its limits.");
}

TEST(LookedAtText, ShowsTheFirstFault) {
  LookedAt one, later;
  one.invalid = later.undecided = 1;
  one.first_fault = {1, Verdict::invalid, "{\"id\":\"first\"}"};
  later.first_fault = {2, Verdict::undecided, "{\"id\":\"second\"}"};
  merge_fields(later, one);
  EXPECT_EQ(faults_text(later, false),
            "Fault: no verdict on 2 valid queries within its limits. The first, invalid: {\"id\":\"first\"}");
  EXPECT_EQ(json_of(later)["first_fault"]["said"], "invalid");
}

}  // namespace
}  // namespace axiscert
