#include "cli/commands/run_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <utility>

#include "reports/instrument/instrument.h"
#include "reports/wording/causes.h"
#include "reports/wording/depths.h"
#include "reports/wording/everyday.h"
#include "reports/wording/evidence.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {

bool output_has_colour() {
  const char *no_colour = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  return isatty(STDOUT_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string coloured(const std::string& text, TextColour colour) {
  if (text.empty() || !output_has_colour()) return text;
  const int code = colour == TextColour::red ? 31 : colour == TextColour::yellow ? 33 : 32;
  const bool has_end = text.back() == '\n';
  return fmt::format("\x1b[{}m{}\x1b[0m{}", code, text.substr(0, text.size() - has_end), has_end ? "\n" : "");
}

namespace {

std::string kernel_text(const KernelRecord& kernel) { return kernel.id + " " + std::string(name(kernel.precision)); }

// Red where a contact is missed or a query has no answer that counts, yellow where the verdict is wrong in another way,
// otherwise green.
std::string kernels_table(const std::vector<KernelRecord>& kernels) {
  std::vector<std::string> columns = {
      "kernel",    "precision", "queries",   "missed contacts",    "deepest",    "phantom contacts", "deepest",
      "undecided", "invalid",   "no answer", "outside its limits", "wrong there"};
  std::vector<std::vector<std::string>> rows;
  std::vector<TextColour> colours;
  bool has_limits = false, has_depth = false;
  for (const KernelRecord& kernel : kernels) {
    const Evidence evidence = evidence_of(kernel);
    std::uint64_t trials = 0, missed = 0, phantom = 0, undecided = 0, outside_wrong = 0, outside_decided = 0;
    double deepest_missed = 0, deepest_phantom = 0;
    for (const auto& [family, result] : kernel.families) {
      const VerdictTally& verdict = result.verdict;
      trials += result.trials;
      missed += verdict.false_separation;
      phantom += verdict.false_contact;
      undecided += verdict.undecided;
      if (const auto& apart = verdict.outside_limits) {
        outside_decided += apart->decided();
        outside_wrong += apart->false_separation + apart->false_contact;
      }
      deepest_missed = std::max(deepest_missed, verdict.deepest_false_separation.best());
      deepest_phantom = std::max(deepest_phantom, verdict.deepest_false_contact.best());
    }
    has_limits |= evidence.outside != 0;
    has_depth |= deepest_missed != 0 || deepest_phantom != 0;
    // Nothing was measured where it decided no query that it could have got wrong so.
    const auto figure = [&](FlipKind kind, std::uint64_t wrong, const std::string& shown) {
      return wrong == 0 && evidence.decided_for(kind) == 0 ? std::string("-") : shown;
    };
    const auto of_missed = [&](const std::string& shown) { return figure(FlipKind::false_separation, missed, shown); };
    const auto of_phantom = [&](const std::string& shown) { return figure(FlipKind::false_contact, phantom, shown); };
    rows.push_back({kernel.id, std::string(name(kernel.precision)), thousands(trials), of_missed(thousands(missed)),
                    of_missed(amount(deepest_missed, 3)), of_phantom(thousands(phantom)),
                    of_phantom(amount(deepest_phantom, 3)), thousands(undecided), thousands(evidence.invalid),
                    thousands(evidence.unanswered), thousands(evidence.outside),
                    outside_decided == 0 ? "-" : thousands(outside_wrong)});
    const bool is_undeclared = undecided != 0 && !kernel.may_decline;
    const bool is_bad =
        missed + evidence.invalid + evidence.unanswered != 0 || is_undeclared || evidence.decided() == 0;
    colours.push_back(is_bad ? TextColour::red : phantom != 0 ? TextColour::yellow : TextColour::green);
  }
  if (rows.empty()) return "";
  if (!has_limits) {
    columns.resize(10);
    for (auto& row : rows) row.resize(10);
  }
  std::istringstream table(aligned_table(columns, rows));
  std::string text, line;
  std::getline(table, text);
  text += "\n";
  for (std::size_t i = 0; std::getline(table, line); ++i) text += coloured(line, colours[i]) + "\n";
  if (has_depth)
    text +=
        "  deepest: the distance of the worst one from being right, as a share of the scene (axiscert explain depth)\n";
  return text;
}

// How deep the wrong verdicts are, by kernel and direction, then on engine-like queries and to which side. Empty where
// nothing is wrong, and for a record of a predicate without depths.
std::string depths_table(const std::vector<KernelRecord>& kernels) {
  std::vector<std::string> columns = {"kernel", "precision", "wrong by, of the scene"};
  columns.insert(columns.end(), depth_columns().begin(), depth_columns().end());
  std::vector<std::vector<std::string>> rows;
  std::string sentences;
  for (const KernelRecord& kernel : kernels) {
    const auto total = all_families(kernel);
    if (!total || !total->verdict.depths) continue;
    const VerdictTally& verdict = total->verdict;
    const auto add_row = [&](std::uint64_t wrong, const char* what, const DecadeCounts& depths) {
      if (wrong == 0) return;
      auto& row = rows.emplace_back(std::vector<std::string>{kernel.id, std::string(name(kernel.precision)), what});
      for (const std::uint64_t count : depth_counts(depths)) row.push_back(thousands(count));
    };
    add_row(verdict.false_separation, "missed", verdict.depths->false_separation);
    add_row(verdict.false_contact, "phantom", verdict.depths->false_contact);
    if (verdict.false_separation + verdict.false_contact == 0) continue;
    const std::string who = kernel_text(kernel);
    for (const std::string& told : {engine_text(*total), bias_text(kernel, *total)}) {
      if (!told.empty()) sentences += fmt::format("{}: {}\n", who, told);
    }
  }
  return rows.empty() ? "" : aligned_table(columns, rows) + sentences;
}

// Why kernels are wrong whose links do not say it, with the deepest witness of each class.
std::string classes_table(const std::vector<KernelRecord>& kernels) {
  const std::vector<std::string> columns = {"kernel",  "precision",        "input is",       "missed contacts",
                                            "deepest", "phantom contacts", "deepest witness"};
  std::vector<std::vector<std::string>> rows;
  std::string nearest;
  for (const KernelRecord& kernel : kernels) {
    for (const ClassRow& row : class_rows(kernel)) {
      rows.push_back({kernel.id, std::string(name(kernel.precision)), std::string(input_class_names[row.which]),
                      thousands(row.missed), amount(row.deepest, 3), thousands(row.phantom), row.witness});
    }
    if (const std::string sentence = nearest_sentence(kernel); !sentence.empty()) {
      nearest += fmt::format("{}: {}\n", kernel_text(kernel), sentence);
    }
  }
  return rows.empty() ? "" : aligned_table(columns, rows) + nearest;
}

// Why kernels are wrong, each in a sentence and with its shortest witness.
std::string causes_text(const Record& record) {
  std::string text;
  for (const KernelRecord& kernel : record.kernels) {
    const std::string line = cause_line(kernel), witness = cause_witness_line(kernel, record.plan);
    if (!line.empty()) text += coloured(line, TextColour::red) + "\n";
    if (!witness.empty()) text += "  " + witness + "\n";
  }
  return text;
}

// What the kernels say beside their verdicts.
std::string contact_table(const Record& record) {
  const bool moves = is_of_motions(predicate_of(record.plan));
  std::vector<std::string> columns = {"kernel", "precision"};
  columns.insert(columns.end(), contact_columns(moves).begin(), contact_columns(moves).end());
  std::vector<std::vector<std::string>> rows;
  for (const KernelRecord& kernel : record.kernels) {
    const auto total = all_families(kernel);
    const std::vector<std::string> cells = total ? contact_cells(*total) : std::vector<std::string>();
    if (cells.empty()) continue;
    auto& row = rows.emplace_back(std::vector<std::string>{kernel.id, std::string(name(kernel.precision))});
    row.insert(row.end(), cells.begin(), cells.end());
  }
  return rows.empty() ? "" : aligned_table(columns, rows);
}

// What a user of each kernel reads first.
std::string first_sentences_text(const Record& record) {
  std::string text;
  for (const KernelRecord& kernel : record.kernels) {
    for (const std::string& sentence : first_sentences(kernel, record.plan))
      text += fmt::format("{}: {}\n", kernel_text(kernel), sentence);
  }
  return text;
}

}  // namespace

std::vector<FindingGroup> findings_of_judged(const Record& record) {
  const std::vector<std::string> told = not_judged(record);
  std::vector<FindingGroup> groups = finding_groups(record);
  std::erase_if(groups, [&](const FindingGroup& group) {
    return std::ranges::find(told, static_cast<const std::string&>(group.first->kernel)) != told.end();
  });
  return groups;
}

std::string summary_text(const Record& record, double seconds) {
  std::string text;
  for (const FindingGroup& group : findings_of_judged(record)) {
    text += finding_text(*group.first) + "\n";
    if (!group.others.empty()) text += fmt::format("  {}\n", group.others_text());
    if (group.first->address) text += fmt::format("  {}\n", replay_command(*group.first, record.plan));
  }
  text += causes_text(record);
  text += first_sentences_text(record);
  text += kernels_table(record.kernels);
  text += contact_table(record);
  text += depths_table(record.kernels);
  text += classes_table(record.kernels);
  text += fmt::format("{}{:.1f} s\n", record.complete ? "" : interrupted_text(record) + "; ", seconds);
  return text;
}

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
