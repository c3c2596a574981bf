#include "reports/formats/markdown_sections.h"

#include <fmt/format.h>

#include "reports/gates/requirement.h"
#include "reports/wording/causes.h"
#include "reports/wording/depths.h"
#include "reports/wording/everyday.h"
#include "reports/wording/markdown_text.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
std::string causes_section(const Record& record) {
  std::string text;
  for (const KernelRecord& kernel : record.kernels) {
    const std::string line = cause_line(kernel), witness = cause_witness_line(kernel, record.plan);
    if (line.empty()) continue;
    text += fmt::format("\n- **{}**", markdown_text(line, 2000));
    if (!witness.empty()) text += fmt::format("; the shortest witness: {}", markdown_text(witness, 2000));
  }
  return text.empty() ? "" : text + "\n";
}

std::string classes_section(const Record& record) {
  Section section("Why, by the class of the input");
  section.add_line(
      "Kernels whose links do not say why they are wrong: each wrong verdict is in the first of these classes whose "
      "definition its input meets.\n");
  bool any = false;
  section.add_head({"kernel", "precision", "class", "what it says", "deepest witness", "missed contacts",
                    "phantom contacts", "deepest"},
                   5);
  for (const KernelRecord& kernel : record.kernels) {
    for (const ClassRow& row : class_rows(kernel)) {
      any = true;
      section.add_row({markdown_text(kernel.id), std::string(name(kernel.precision)), std::string(name(row.which)),
                       std::string(class_words[row.which].meaning), markdown_text(row.witness), thousands(row.missed),
                       thousands(row.phantom), amount(row.deepest, 4)});
    }
  }
  for (const KernelRecord& kernel : record.kernels) {
    const std::string nearest = nearest_sentence(kernel);
    if (nearest.empty()) continue;
    section.add_line(
        fmt::format("\n{} {}: {}.", markdown_text(kernel.id), name(kernel.precision), markdown_text(nearest, 2000)));
  }
  return any ? section.text() : "";
}

namespace {

// Adds a row for each direction in which a verdict of `family` is wrong.
void add_depth_rows(Section& section, const KernelRecord& kernel, const std::string& family_name,
                    const FamilyRecord& family) {
  const VerdictTally& verdict = family.verdict;
  const auto add = [&](const char* what, std::uint64_t wrong, const DecadeCounts& depths) {
    if (wrong == 0) return;
    std::vector<std::string> cells = {markdown_text(kernel.id), std::string(name(kernel.precision)),
                                      markdown_text(family_name), what};
    for (const std::uint64_t count : depth_counts(depths)) cells.push_back(thousands(count));
    section.add_row(cells);
  };
  if (!verdict.depths) return;
  add("missed", verdict.false_separation, verdict.depths->false_separation);
  add("phantom", verdict.false_contact, verdict.depths->false_contact);
}

}  // namespace

std::string depths_section(const Record& record) {
  Section section("Depth of wrong verdicts");
  section.add_line(
      "Wrong verdicts by depth, each column from its depth to that of the next one; zero is a sphere that touches. An "
      "engine-like query has numbers that are zero or normal, coordinates to 2^20 and a radius from 2^-20 to 2^20; a "
      "wrong "
      "verdict counts there where its depth is above 16 u.\n");
  std::vector<std::string> columns = {"kernel", "precision", "family", "wrong"};
  columns.insert(columns.end(), depth_columns().begin(), depth_columns().end());
  section.add_head(columns, 4);
  bool any = false;
  std::string sentences;
  for (const KernelRecord& kernel : record.kernels) {
    const std::optional<FamilyRecord> total = all_families(kernel);
    if (!total || !total->verdict.depths) continue;
    if (total->verdict.false_separation == 0 && total->verdict.false_contact == 0) continue;
    any = true;
    add_depth_rows(section, kernel, "all", *total);
    for (const auto& [family, result] : kernel.families) add_depth_rows(section, kernel, family, result);
    for (const std::string& told : {engine_text(*total), bias_text(kernel, *total)}) {
      if (!told.empty())
        sentences += fmt::format("\n{} {}: {}.\n", markdown_text(kernel.id), name(kernel.precision), told);
    }
  }
  section.add(sentences);
  return any ? section.text() : "";
}

std::string contact_section(const Record& record) {
  const bool moves = is_of_motions(predicate_of(record.plan));
  Section section(moves ? "First contacts" : "Contacts");
  section.add_line(std::string(contact_note(moves)) + " In brackets: on how many answers, where not on all.\n");
  std::vector<std::string> columns = {"kernel", "precision", "family"};
  columns.insert(columns.end(), contact_columns(moves).begin(), contact_columns(moves).end());
  section.add_head(columns, 3);
  bool any = false;
  for (const KernelRecord& kernel : record.kernels) {
    const auto add = [&](const std::string& shown_name, const FamilyRecord& family) {
      const std::vector<std::string> cells = contact_cells(family);
      if (cells.empty()) return;
      any = true;
      std::vector<std::string> row = {markdown_text(kernel.id), std::string(name(kernel.precision)),
                                      markdown_text(shown_name)};
      row.insert(row.end(), cells.begin(), cells.end());
      section.add_row(row);
    };
    if (const auto total = all_families(kernel)) add("all", *total);
    for (const auto& [family, result] : kernel.families) add(family, result);
  }
  return any ? section.text() : "";
}

namespace {

std::string failure_line(const Failure& f) {
  if (f.family.empty()) return fmt::format("- {}: {}", markdown_text(f.kernel), markdown_text(f.what, 2000));
  return fmt::format("- {} {} on {}: {}: {}{}", markdown_text(f.kernel), f.precision, markdown_text(f.family),
                     markdown_text(f.what, 2000), thousands(f.count),
                     f.witness.empty() ? "" : ", witness " + markdown_text(f.witness));
}

std::string meaning_of(const LevelOutcome& outcome) {
  switch (outcome.state) {
    case LevelState::met:
      return fmt::format("covers {}; leaves out {}", markdown_text(outcome.covers, 2000),
                         markdown_text(outcome.leaves_out, 2000));
    case LevelState::not_met:
      return markdown_text(reason_text(outcome), 2000);
    case LevelState::not_checked:
      break;
  }
  return markdown_text(outcome.reason, 2000);
}

}  // namespace

std::string answer_section(const Record& record) {
  Section section("The answer");
  const FirstLevels first = first_levels(record);
  section.add_line(first.lead + "\n");
  if (!first.outcomes.empty())
    section.add_head({"level", "kernel", "precision", "state", "how much was looked at", "what that says"}, 6);
  for (const LevelOutcome& outcome : first.outcomes) {
    const std::string state(state_text(&outcome));
    section.add_row({markdown_text(outcome.claim()), markdown_text(outcome.kernel), outcome.precision,
                     outcome.passes() ? state : fmt::format("**{}**", state), outcome.looked_text(),
                     meaning_of(outcome)});
  }
  if (const WitnessRecord* worst = worst_scene(record)) {
    section.add(fmt::format("\nThe worst: {} {} {}. Family {}, witness {}.\n\n{}", markdown_text(worst->kernel),
                            name(worst->precision), scene_words(*worst, record.plan), markdown_text(worst->family),
                            markdown_text(worst->id), code_block(replay_command(*worst, record.plan))));
  }
  for (const KernelRecord& kernel : record.kernels) {
    section.add_line(fmt::format("\n{} {}:\n", markdown_text(kernel.id), name(kernel.precision)));
    for (const std::string& sentence : first_sentences(kernel, record.plan))
      section.add_line("- " + markdown_text(sentence, 2000));
  }
  return section.text();
}

std::string requirements_section(const Record& record, const std::vector<LevelOutcome>& outcomes) {
  const Requirements required = requirements_of(record.plan);
  if (required.levels.empty()) return "";
  Section section("Requirements");
  for (const AskedLevel& asked : required.levels)
    section.add_line(
        fmt::format("Requirement `{}`: {}.\n", markdown_text(asked.text), markdown_text(sentence_of(asked), 2000)));
  section.add_line(pass(outcomes) ? "The gate passes.\n" : "**The gate fails**: what is not checked does not pass.\n");
  for (const Failure& failure : failures_of(outcomes)) section.add_line(failure_line(failure));
  return section.text();
}

namespace {

using Cells = std::vector<std::string>;

std::string measured(std::optional<std::uint64_t> count) { return count ? thousands(*count) : "not measured"; }

// The figures that only one of the two levels has.
Cells own_cells(const AxisTally& tally) { return {measured(tally.sole_separator)}; }
Cells own_cells(const ComparisonTally& tally) {
  return {measured(tally.ties), measured(tally.range_events), measured(tally.error_without_scale)};
}

template <class Tally>
std::string signs_section(const std::string& title, const std::string& level, const Cells& own_columns,
                          const Record& record, const std::vector<std::optional<FamilyRecord>>& totals,
                          std::optional<NamedValues<Tally>> FamilyCounts::*signs) {
  Section section(title);
  Cells columns = {"kernel", "precision",          level,        "false_separation", "missed_separation", "decisive",
                   "masked", "tolerance failures", "max_error_u"};
  columns.insert(columns.end(), own_columns.begin(), own_columns.end());
  section.add_head(columns, 3);
  std::vector<Cells> with_flips, without;
  for (std::size_t k = 0; k < totals.size(); ++k) {
    if (!totals[k]) continue;
    const KernelRecord& kernel = record.kernels[k];
    const Cells of = {markdown_text(kernel.id), std::string(name(kernel.precision))};
    if (!((*totals[k]).*signs)) {
      Cells& cells = without.emplace_back(of);
      cells.emplace_back("not exposed");
      cells.resize(columns.size());
      continue;
    }
    for (const auto& [sign, tally] : *((*totals[k]).*signs)) {
      const bool has_flips = tally.false_separation != 0 || tally.missed_separation != 0;
      Cells& cells = (has_flips ? with_flips : without).emplace_back(of);
      cells.push_back(sign);
      for (const std::uint64_t count : {tally.false_separation, tally.missed_separation, tally.decisive, tally.masked})
        cells.push_back(tally.judged == 0 ? "-" : thousands(count));
      cells.push_back(count_text(tally.tolerance_failures));
      cells.push_back(error_amount(tally.max_error));
      for (const std::string& cell : own_cells(tally)) cells.push_back(cell);
    }
  }
  for (const auto* rows : {&with_flips, &without}) {
    for (const Cells& cells : *rows) section.add_row(cells);
  }
  section.add_line("\nmax_error_u is also the smallest tolerance that passes.");
  return section.text();
}

}  // namespace

std::string axes_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals) {
  return signs_section("Axes, over all families", "axis", {"sole_separator"}, record, totals, &FamilyCounts::axes);
}
std::string comparisons_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals) {
  return signs_section("Comparisons, over all families", "comparison", {"ties", "range_events", "error_without_scale"},
                       record, totals, &FamilyCounts::comparisons);
}

}  // namespace axiscert
