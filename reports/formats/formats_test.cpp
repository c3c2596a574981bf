// The list of report formats: every one that is defined is in it, and all are written, the same bytes every time.
#include <algorithm>

#include "kernel/testing/sources.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

TEST(Reports, EveryFormatThatIsDefinedIsListed) {
  constexpr const char* definition = R"re(extern const Format \w+_format = \{\s*"([^"]+)")re";
  for (const auto& [written, source] : testing_support::defined_in("reports", definition)) {
    EXPECT_TRUE(std::any_of(formats().begin(), formats().end(),
                            [&, &file = written](const Format* format) { return format->file == file; }))
        << source << " defines the format of " << written << ", which the list of reports/formats/render.cpp lacks";
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
}  // namespace axiscert
