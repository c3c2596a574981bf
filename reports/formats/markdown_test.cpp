// The contents of report.md, and the lines of witnesses.jsonl.
#include "fuzz/text/json.h"
#include "reports/testing/test_run.h"

#include <sstream>

#include "reports/gates/requirement.h"
#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Markdown, EscapesNames) {
  const TestFolder folder(named("a|b`<script>\n# c"));
  render_reports(folder.path());
  std::string text = folder.read("report.md");
  EXPECT_THAT(text, HasSubstr("a\\|b\\`&lt;script>\\\\n#<!-- --> c"));
  // Fenced commands show the name as it is.
  for (std::size_t open = text.find("```"); open != text.npos; open = text.find("```")) {
    text.erase(open, text.find("```", open + 3) + 3 - open);
  }
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_THAT(text, Not(HasSubstr("a|b")));
}

// Texts that a forge would interpret in a comment: mentions, issues, addresses, formulae, links, emphasis.
TEST(Markdown, NamesMentionAndLinkNothing) {
  EXPECT_EQ(markdown_text("@octocat"), "@<!-- -->octocat");
  EXPECT_EQ(markdown_text("org/repo#12"), "org/repo#<!-- -->12");
  EXPECT_EQ(markdown_text("https://a.example www.b.example"), "https:<!-- -->//a.example w<!-- -->ww.b.example");
  EXPECT_EQ(markdown_text("[a](b) ![c](d)"), "\\[a\\](b) !\\[c\\](d)");
  EXPECT_EQ(markdown_text("_a_ edge_ab __b__ $x$"), "\\_a\\_ edge_ab \\_\\_b\\_\\_ \\$x\\$");
  EXPECT_EQ(markdown_text("a\r\n<img src=x>&lt;"), "a  &lt;img src=x>&amp;lt;");
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

TEST(Witnesses, AreTheRecordsQueriesLineByLine) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  std::istringstream lines(folder.read("witnesses.jsonl"));
  std::string line;
  const Json record = stored_record();
  for (const Json& witness : record["witnesses"]) {
    ASSERT_TRUE(std::getline(lines, line));
    const Json query = Json::parse(line);
    EXPECT_EQ(query.size(), 8u);
    for (const auto& [member, value] : query.items()) EXPECT_EQ(value, witness[member]) << member;
  }
  EXPECT_FALSE(std::getline(lines, line));
}

}  // namespace
}  // namespace axiscert
