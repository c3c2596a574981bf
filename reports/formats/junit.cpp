// junit.xml, by the schema of Ant's JUnit task, for CI systems: one suite for each kernel and precision. Its cases: one
// for the verdict of each family, failed where a requirement is not met there; one for each requirement that is not
// checked, failed unless that is allowed; one for each finding, always failed; one for each family and comparison that
// the kernel shows, failed where an error exceeds its tolerance. A case also fails where it is worse than the ratchet
// accepts, and is skipped, with the text NOT CHECKED, where nothing was required of it. The ratchet's failures that
// belong to none of these cases have a suite of their own.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/text/json_form.h"
#include "kernel/names.h"
#include "reports/comparison/cells.h"
#include "reports/wording/summary.h"
#include "reports/formats/format.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/evidence.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

// Escapes text for elements and attributes. XML 1.0 has no way to write most control characters, U+FFFE or U+FFFF.
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
  std::string name, cases = {}, figures = {};
  int tests = 0, failures = 0, skipped = 0;

  // `outcome`: a failure or skipped element, or empty. The counts go to the suite's output, a line for each case: Ant's
  // schema has no output of a single case.
  void add(const std::string& test, const std::string& outcome, const Json& counts) {
    ++tests;
    failures += outcome.starts_with("<failure");
    skipped += outcome.starts_with("<skipped");
    const std::string head = fmt::format("classname=\"{}\" name=\"{}\" time=\"0\"", xml(name), xml(test));
    cases += outcome.empty() ? fmt::format("    <testcase {}/>\n", head)
                             : fmt::format("    <testcase {}>\n      {}\n    </testcase>\n", head, outcome);
    figures += fmt::format("{}: {}\n", test, counts.dump());
  }
};

std::string failure(const std::string& type, const std::string& message, const std::string& detail) {
  return fmt::format("<failure type=\"{}\" message=\"{}\">{}</failure>", xml(type), xml(message), xml(detail));
}
std::string skipped_element(const std::string& why) {
  return fmt::format("<skipped message=\"{}\"/>", xml("NOT CHECKED: " + why));
}

// The place of a failure's cell, whose name ends with the figure.
std::string place_of(const RatchetFailure& failure) { return failure.cell.substr(0, failure.cell.rfind('.')); }

bool is_of_kernel(const RatchetFailure& failure, const KernelRecord& kernel) {
  return failure.kernel == kernel.id && failure.precision == name(kernel.precision);
}

// Whether a failure of ratchet.json is about this case: a family's verdict, with what is said of its contacts, or
// comparison.
bool is_about_case(const RatchetFailure& failure, const KernelRecord& kernel, const std::string& family,
                   const std::string& place) {
  if (!is_of_kernel(failure, kernel) || failure.family != family) return false;
  const std::string given = place_of(failure);
  return given == place || (place == "verdict" && is_place_of_contacts(given));
}

// The ratchet's failures for a case of a run with --ratchet; empty where there are none.
std::string ratchet_outcome(const RatchetOutcome& held, const KernelRecord& kernel, const std::string& family,
                            const std::string& place) {
  std::string detail;
  for (const RatchetFailure& failure : held.failures) {
    if (is_about_case(failure, kernel, family, place)) detail += failure.text + "\n";
  }
  return detail.empty() ? "" : failure("ratchet", "worse than accepted, or expired", detail);
}

std::string verdict_outcome(const std::vector<LevelOutcome>& outcomes, const KernelRecord& kernel,
                            const std::string& family) {
  std::string message, detail, why_skipped = "nothing is required of it (--require)";
  const Evidence evidence = evidence_of(kernel, kernel.families.at(family));
  bool is_seen = false;
  for (const LevelOutcome& outcome : outcomes) {
    if (!outcome.is_of(kernel)) continue;
    std::string falls_short;
    for (const Failure& f : outcome.failures) {
      if (f.family == family) falls_short += f.text() + "\n";
    }
    if (!falls_short.empty()) {
      message += fmt::format("{}requirement {} is not met: {}", message.empty() ? "" : "; ", outcome.asked.text,
                             sentence_of(outcome.asked));
      detail += falls_short;
    }
    const bool is_unseen = std::find(outcome.unseen.begin(), outcome.unseen.end(), family) != outcome.unseen.end();
    if (outcome.state == LevelState::not_checked) why_skipped = outcome.reason;
    else if (is_unseen) why_skipped = fmt::format("{}: this kernel's answers here cannot show it", outcome.asked.text);
    else is_seen = true;
  }
  if (!detail.empty()) return failure("requirement", message, detail);
  if (evidence.decided() == 0) return skipped_element(evidence_text(evidence, 0));
  return is_seen ? "" : skipped_element(why_skipped);
}

// A case for each level that is not checked: failed, or skipped where that is allowed. And a failed one for each level
// with failures that no family shows.
void add_unchecked(Suite& suite, const std::vector<LevelOutcome>& outcomes, const KernelRecord& kernel) {
  for (const LevelOutcome& outcome : outcomes) {
    if (!outcome.is_of(kernel)) continue;
    const std::string name = "requirement " + outcome.asked.text;
    std::string beside;
    for (const Failure& failed : outcome.failures) {
      if (failed.is_beside_families) beside += failed.text() + "\n";
    }
    if (!beside.empty()) {
      suite.add(
          name,
          failure("requirement",
                  fmt::format("requirement {} is not met: {}", outcome.asked.text, sentence_of(outcome.asked)), beside),
          Json::object());
    }
    if (outcome.state != LevelState::not_checked) continue;
    if (outcome.is_allowed) suite.add(name, skipped_element(outcome.reason), Json::object());
    else suite.add(name, failure("not checked", outcome.text(), outcome.text()), Json::object());
  }
}

// `tolerance`: null where none was given.
std::string tolerance_outcome(const ComparisonTally& tally, const std::string* tolerance) {
  if (tolerance == nullptr) return skipped_element("no tolerance was given for it (--tolerance)");
  if (!tally.tolerance_failures)
    return skipped_element(tally.range_events ? "no query has finite sides and a scale"
                                              : "the kernel does not show its sides");
  if (*tally.tolerance_failures == 0) return "";
  const std::string message =
      fmt::format("{} errors above {} u; the smallest tolerance that passes is {} u",
                  thousands(*tally.tolerance_failures), *tolerance, error_amount(tally.smallest_passing_tolerance()));
  return failure("tolerance", message, message);
}

// Whether a failure of the ratchet is about everything of the kernel in this precision: that it promises less, say, so
// that no figure of it was compared.
bool fails_as_a_whole(const RatchetOutcome& held, const KernelRecord& kernel) {
  return std::any_of(held.failures.begin(), held.failures.end(),
                     [&](const RatchetFailure& failure) { return is_about_case(failure, kernel, "*", "*"); });
}

// A case's outcome together with the ratchet's: Ant's schema allows one failure for each case. A case of which nothing
// else was required was still checked by the ratchet, where the kernel decided something.
std::string with_ratchet(const RatchetOutcome& held, const KernelRecord& kernel, const std::string& family,
                         const std::string& place, const std::string& outcome) {
  const std::string worse = ratchet_outcome(held, kernel, family, place);
  const bool is_checked =
      evidence_of(kernel, kernel.families.at(family)).decided() != 0 && !fails_as_a_whole(held, kernel);
  if (worse.empty()) return outcome.starts_with("<skipped") && is_checked ? "" : outcome;
  if (!outcome.starts_with("<failure")) return worse;
  const std::string_view end = "</failure>";
  const std::size_t text = worse.find('>') + 1;
  return outcome.substr(0, outcome.size() - end.size()) + worse.substr(text);
}

void add_finding(Suite& suite, const FindingRecord& finding, const PlanRecord& plan) {
  const std::string family = finding.family.value_or("loading"), command = replay_command(finding, plan);
  const std::string text = finding_text(finding), replay = command.empty() ? "" : "\n" + command;
  suite.add(fmt::format("{} {}", family, name(finding.kind)), failure("finding", text, text + replay),
            json_of(finding));
}

// The suite of a kernel that could not be loaded.
Suite suite_of_findings(const Record& record, const std::string& kernel) {
  Suite suite{kernel};
  for (const FindingRecord& finding : record.findings) {
    if (finding.kernel == kernel) add_finding(suite, finding, record.plan);
  }
  return suite;
}

Suite suite_of(const Run& run, const KernelRecord& kernel, const std::vector<LevelOutcome>& outcomes) {
  const Record& record = run.record;
  Suite suite{fmt::format("{} {}", kernel.id, name(kernel.precision))};
  for (const FindingRecord& finding : record.findings) {
    if (is_about(finding, kernel)) add_finding(suite, finding, record.plan);
  }
  for (const std::string& sentence : unjudged(record)) {
    if (sentence.starts_with(suite.name + ": "))
      suite.add("judged", failure("not judged", sentence, sentence), Json::object());
  }
  add_unchecked(suite, outcomes, kernel);
  for (const std::string& family : record.plan.families) {
    const FamilyRecord* const result = kernel.families.find(family);
    if (result == nullptr) {
      suite.add(family + " verdict", skipped_element("no query of this family was run"), Json::object());
      continue;
    }
    Json counts = {{"trials", result->trials}, {"truth", json_of(result->truth)}};
    counts.update(json_of(result->verdict));
    const auto held = [&](const std::string& place, const std::string& outcome) {
      return run.ratchet ? with_ratchet(*run.ratchet, kernel, family, place, outcome) : outcome;
    };
    suite.add(family + " verdict", held("verdict", verdict_outcome(outcomes, kernel, family)), counts);
    if (!result->comparisons) continue;  // said once, below
    for (const auto& [comparison, tally] : *result->comparisons) {
      const std::string outcome = tolerance_outcome(tally, record.plan.tolerance.find(comparison));
      suite.add(family + " " + comparison, held(comparison, outcome), json_of(tally));
    }
  }
  if (kernel.exposes == std::vector{Exposure::verdict})
    suite.add("comparisons", skipped_element("the kernel shows only verdicts"), Json::object());
  if (!record.complete) {
    const std::string message = interrupted_text(record) + "; the results cover only the queries that were run";
    suite.add("complete", failure("interrupted", message, message), Json::object());
  }
  return suite;
}

// The ratchet's failures of cells that have no case: findings, and kernels that were not judged.
Suite suite_of_ratchet(const Run& run) {
  Suite suite{"ratchet"};
  const auto has_case = [&](const RatchetFailure& failure) {
    const std::string place = place_of(failure);
    if (place == "finding") return false;
    for (const KernelRecord& kernel : run.record.kernels) {
      if (!is_of_kernel(failure, kernel)) continue;
      const FamilyRecord* const family = kernel.families.find(failure.family);
      if (family == nullptr) continue;
      return place == "verdict" || is_place_of_contacts(place) || family->comparisons.has_value();
    }
    return false;
  };
  for (const RatchetFailure& failed : run.ratchet->failures) {
    if (has_case(failed)) continue;
    suite.add(fmt::format("{} {} {} {}", failed.kernel, failed.precision, failed.family, failed.cell),
              failure("ratchet", failed.text, failed.text), failed.fingerprint);
  }
  return suite;
}

// Start of the run in UTC, in the schema's form, which has no zone. A record alone does not contain it.
std::string start_text(const Run& run) { return run.info ? run.info->started.substr(0, 19) : "1970-01-01T00:00:00"; }
// Kernels share their run, so the first suite has its seconds.
std::string seconds(const Run& run) { return run.info ? fmt::format("{:.3f}", run.info->seconds) : "0"; }

std::string render_junit(const Run& run) {
  const std::vector<LevelOutcome> outcomes = outcomes_of(run.record);
  std::string suites;
  std::size_t id = 0;
  std::vector<Suite> listed;
  for (const std::string& kernel : not_judged(run.record)) listed.push_back(suite_of_findings(run.record, kernel));
  for (const KernelRecord& kernel : run.record.kernels) listed.push_back(suite_of(run, kernel, outcomes));
  if (run.ratchet) {
    if (Suite rest = suite_of_ratchet(run); rest.tests != 0) listed.push_back(std::move(rest));
  }
  for (const Suite& suite : listed) {
    suites += fmt::format(
        "  <testsuite name=\"{0}\" tests=\"{3}\" failures=\"{4}\" errors=\"0\" skipped=\"{5}\" "
        "package=\"axiscert\" "
        "id=\"{1}\" hostname=\"localhost\" timestamp=\"{2}\" time=\"{6}\">\n    <properties/>\n{7}"
        "    <system-out>{8}</system-out>\n    <system-err/>\n  </testsuite>\n",
        xml(suite.name), id, xml(start_text(run)), suite.tests, suite.failures, suite.skipped,
        id == 0 ? seconds(run) : "0", suite.cases, xml(suite.figures));
    ++id;
  }
  // Ant's schema has no totals: each suite has its own counts.
  return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n{}</testsuites>\n", suites);
}

}  // namespace

extern const Format junit_format = {"junit.xml", "for CI", render_junit};

}  // namespace axiscert
