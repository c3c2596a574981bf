#include "cli/running/brief_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "cli/running/run_output.h"
#include "reports/wording/causes.h"
#include "reports/wording/everyday.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Texts in the order in which they came, each with those that share it.
class SharedTexts {
 public:
  void add(const std::string& text, const std::string& who) {
    const auto found = std::ranges::find(texts_, text, &Shared::first);
    if (found == texts_.end()) texts_.push_back({text, {who}});
    else if (std::ranges::find(found->second, who) == found->second.end()) found->second.push_back(who);
  }
  using Shared = std::pair<std::string, std::vector<std::string>>;
  const std::vector<Shared>& all() const { return texts_; }

 private:
  std::vector<Shared> texts_;
};

std::vector<std::string> ids_in_order(const Record& record) {
  std::vector<std::string> ids;
  for (const KernelRecord& kernel : record.kernels) {
    const std::string& id = kernel.id;
    if (std::ranges::find(ids, id) == ids.end()) ids.push_back(id);
  }
  return ids;
}

// The report has further findings.
std::string first_finding(const Record& record) {
  const std::vector<FindingGroup> groups = findings_of_judged(record);
  if (groups.empty()) return "";
  const FindingGroup& first = groups.front();
  const std::size_t others = groups.size() - 1 + !first.others.empty();
  std::string text = finding_text(*first.first);
  if (others != 0) text += "; the report has more";
  text += "\n";
  if (first.first->address) text += fmt::format("  {}\n", replay_command(*first.first, record.plan));
  return text;
}

// The report has the cause in another precision, where it is another.
std::string first_cause(const Record& record, const std::string& id) {
  SharedTexts causes;
  std::string witness;
  for (const KernelRecord& kernel : record.kernels) {
    const std::string sentence = cause_sentence(kernel);
    if (static_cast<const std::string&>(kernel.id) != id || sentence.empty()) continue;
    causes.add(sentence, std::string(name(kernel.precision)));
    if (witness.empty() && causes.all().size() == 1) witness = cause_witness_line(kernel, record.plan);
  }
  if (causes.all().empty()) return "";
  const auto& [sentence, precisions] = causes.all().front();
  std::string text = fmt::format("{} {}: {}", id, fmt::join(precisions, " and "), sentence);
  if (causes.all().size() > 1)
    text += fmt::format("; in {} another, in the report", fmt::join(causes.all()[1].second, " and "));
  text = coloured(text, TextColour::red) + "\n";
  return witness.empty() ? text : text + fmt::format("  {}\n", witness);
}

// Those about queries, a line for each that differs; those about units of length in one line.
std::string sentences_about(const Record& record, const std::string& id) {
  constexpr std::string_view of_units = "in other units: ";
  SharedTexts of_queries, units;
  for (const KernelRecord& kernel : record.kernels) {
    if (static_cast<const std::string&>(kernel.id) != id) continue;
    for (const std::string& sentence : first_sentences(kernel, record.plan)) {
      const bool is_of_units = sentence.starts_with(of_units);
      (is_of_units ? units : of_queries)
          .add(is_of_units ? sentence.substr(of_units.size()) : sentence, std::string(name(kernel.precision)));
    }
  }
  std::string text;
  for (const auto& [sentence, precisions] : of_queries.all())
    text += fmt::format("{} {}: {}\n", id, fmt::join(precisions, " and "), sentence);
  if (units.all().size() == 1) {
    const auto& [sentence, precisions] = units.all().front();
    text += fmt::format("{} {}: {}{}\n", id, fmt::join(precisions, " and "), of_units, sentence);
  } else if (!units.all().empty()) {
    std::vector<std::string> each;
    for (const auto& [sentence, precisions] : units.all())
      each.push_back(fmt::format("{} {}", fmt::join(precisions, " and "), sentence));
    text += fmt::format("{}: {}{}\n", id, of_units, fmt::join(each, "; "));
  }
  return text;
}

// The family with the most failures of levels that are not met, without their details.
std::string most_failures_text(const std::vector<Failure>& failures) {
  const auto most = std::ranges::max_element(failures, {}, &Failure::count);
  if (most == failures.end()) return "";
  if (most->family.empty()) return "; " + most->what;
  const std::size_t details = std::min(most->what.find(','), most->what.find(" ("));
  return fmt::format("; most on {}: {} {}", most->family, thousands(most->count), most->what.substr(0, details));
}

}  // namespace

std::string brief_text(const Record& record) {
  std::string text = first_finding(record);
  const bool has_finding = !text.empty();
  for (const std::string& id : ids_in_order(record)) {
    if (!has_finding) text += first_cause(record, id);
    text += sentences_about(record, id);
  }
  return text;
}

BriefOutcomes brief_outcomes(const std::vector<LevelOutcome>& outcomes) {
  struct Line {
    std::string kernel, state, reason;
    bool is_passing;
    SharedTexts levels;
    std::vector<Failure> failures;
  };
  std::vector<Line> lines;
  SharedTexts precisions;  // by kernel
  for (const LevelOutcome& outcome : outcomes) {
    const std::string state = fmt::format("{}{}", name(outcome.state), outcome.is_allowed ? ", which is allowed" : "");
    auto line = std::ranges::find_if(lines, [&](const Line& one) {
      return one.kernel == outcome.kernel && one.state == state && one.reason == outcome.reason;
    });
    if (line == lines.end())
      line = lines.insert(lines.end(), Line{outcome.kernel, state, outcome.reason, outcome.passes(), {}, {}});
    line->levels.add(outcome.asked.text, outcome.precision);
    line->failures.insert(line->failures.end(), outcome.failures.begin(), outcome.failures.end());
    precisions.add(outcome.kernel, outcome.precision);
  }
  BriefOutcomes brief;
  for (const Line& line : lines) {
    const auto& all = std::ranges::find(precisions.all(), line.kernel, &SharedTexts::Shared::first)->second;
    std::vector<std::string> levels;
    for (const auto& [level, in] : line.levels.all())
      levels.push_back(in.size() == all.size() ? level : fmt::format("{} in {}", level, fmt::join(in, " and ")));
    (line.is_passing ? brief.passing : brief.failing)
        .push_back(fmt::format("{}: {}: {}{}{}", line.kernel, line.state, fmt::join(levels, ", "),
                               line.reason.empty() ? "" : ": " + line.reason, most_failures_text(line.failures)));
  }
  return brief;
}

}  // namespace axiscert
