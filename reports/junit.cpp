// junit.xml: one suite a kernel and precision, for CI systems. A case a family for the verdict, failed where the run's
// requirement is not met there; a case a finding, always failed; a case a family and comparison that has a tolerance,
// failed where an error exceeds it.
#include <fmt/format.h>

#include <algorithm>

#include "kernel/names.h"
#include "reports/finding.h"
#include "reports/format.h"
#include "reports/reproduce.h"
#include "reports/requirement.h"
#include "reports/summary.h"

namespace axiscert {
namespace {

// For text and attributes. XML 1.0 has no way to write most control characters, U+FFFE or U+FFFF.
std::string xml(const std::string& text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const unsigned char c = static_cast<unsigned char>(text[i]);
    const bool is_noncharacter = text.compare(i, 3, "\xEF\xBF\xBE") == 0 || text.compare(i, 3, "\xEF\xBF\xBF") == 0;
    if (c == '&') escaped += "&amp;";
    else if (c == '<') escaped += "&lt;";
    else if (c == '>') escaped += "&gt;";
    else if (c == '"') escaped += "&quot;";
    else if (c == '\t' || c == '\n' || c == '\r') escaped += fmt::format("&#{};", c);
    else if (c < 0x20 || is_noncharacter) escaped += "\xEF\xBF\xBD";
    else escaped += static_cast<char>(c);
    if (is_noncharacter) i += 2;
  }
  return escaped;
}

struct Suite {
  std::string name, cases;
  int tests = 0, failures = 0, skipped = 0;

  // `outcome`: a failure or skipped element, or empty. `counts` goes to the case's output.
  void add(const std::string& test, const std::string& outcome, const Json& counts) {
    ++tests;
    failures += outcome.starts_with("<failure");
    skipped += outcome.starts_with("<skipped");
    cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n", xml(name), xml(test));
    if (!outcome.empty()) cases += "      " + outcome + "\n";
    cases += fmt::format("      <system-out>{}</system-out>\n    </testcase>\n", xml(counts.dump()));
  }
};

std::string failure(const std::string& message, const std::string& detail) {
  return fmt::format("<failure message=\"{}\">{}</failure>", xml(message), xml(detail));
}
std::string skipped(const std::string& why) {
  return fmt::format("<skipped message=\"{}\"/>", xml("NOT CHECKED: " + why));
}

std::string verdict_outcome(const Json& require, const std::vector<Failure>& failures, const Json& kernel,
                            const std::string& family) {
  if (require.is_null()) return skipped("no requirement was asked (--require)");
  std::string detail;
  for (const Failure& f : failures) {
    if (f.family == family && f.is_of(kernel)) detail += f.text() + "\n";
  }
  if (detail.empty()) return "";
  const std::string level = require;
  return failure(fmt::format("requirement {} is not met: {}", level, parse_requirement(level).sentence()), detail);
}

std::string tolerance_outcome(const Json& tally, const std::string& tolerance) {
  if (tally.is_null() || tally["tolerance_failures"].is_null()) return skipped("the kernel does not show its sides");
  if (tally["tolerance_failures"] == 0) return "";
  const std::string message = fmt::format("{} errors above {} u; the smallest tolerance that passes is {} u",
                                          thousands(tally["tolerance_failures"].get<std::uint64_t>()), tolerance,
                                          error_amount(tally["smallest_passing_tolerance"]));
  return failure(message, message);
}

void add_finding(Suite& suite, const Json& finding, const Json& plan) {
  const std::string family = finding["family"].is_null() ? "loading" : finding["family"].get<std::string>();
  const std::string replay = finding["address"].is_null() ? "" : "\n" + replay_command(finding, plan);
  const std::string text = finding_text(finding);
  suite.add(family + " " + finding["kind"].get<std::string>(), failure(text, text + replay), finding);
}

// A kernel that could not be loaded.
Suite suite_of_findings(const Run& run, const std::string& kernel) {
  Suite suite{kernel, ""};
  for (const Json& finding : run.record["findings"]) {
    if (finding["kernel"] == kernel) add_finding(suite, finding, run.record["plan"]);
  }
  return suite;
}

Suite suite_of(const Run& run, const Json& kernel, const std::vector<Failure>& failures) {
  const Json& plan = run.record["plan"];
  Suite suite{fmt::format("{} {}", kernel["id"].get<std::string>(), kernel["precision"].get<std::string>()), ""};
  for (const Json& finding : run.record["findings"]) {
    if (is_about(finding, kernel)) add_finding(suite, finding, run.record["plan"]);
  }
  for (const Json& name : plan["families"]) {
    const std::string family = name;
    if (!kernel["families"].contains(family)) {
      suite.add(family + " verdict", skipped("no query of this family was asked"), Json::object());
      continue;
    }
    const Json& result = kernel["families"][family];
    Json counts = {{"trials", result["trials"]}, {"truth", result["truth"]}};
    counts.update(result["verdict"]);
    suite.add(family + " verdict", verdict_outcome(plan["require"], failures, kernel, family), counts);
    for (const auto& [comparison, tolerance] : plan["tolerance"].items()) {
      const Json tally = result["comparisons"].is_null() ? Json(nullptr) : result["comparisons"][comparison];
      suite.add(family + " " + comparison, tolerance_outcome(tally, tolerance), tally);
    }
  }
  if (!run.record["complete"].get<bool>()) {
    const std::string message = "the run was interrupted: what is here is about the queries that were asked";
    suite.add("complete", failure(message, message), Json::object());
  }
  return suite;
}

std::string render(const Run& run) {
  const Json& require = run.record["plan"]["require"];
  const std::vector<Failure> failures = require.is_null() ? std::vector<Failure>() : unmet(run.record, require);
  std::string suites;
  Suite all;
  std::vector<Suite> listed;
  for (const std::string& kernel : not_judged(run.record)) listed.push_back(suite_of_findings(run, kernel));
  for (const Json& kernel : run.record["kernels"]) listed.push_back(suite_of(run, kernel, failures));
  for (const Suite& suite : listed) {
    suites += fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}  </testsuite>\n",
        xml(suite.name), suite.tests, suite.failures, suite.skipped, suite.cases);
    all.tests += suite.tests;
    all.failures += suite.failures;
    all.skipped += suite.skipped;
  }
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"axiscert\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}</testsuites>\n",
      all.tests, all.failures, all.skipped, suites);
}

}  // namespace

extern const Format junit_format = {"junit.xml", render};

}  // namespace axiscert
