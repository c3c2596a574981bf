#include "reports/comparison/comparison_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "fuzz/text/json_form.h"
#include "kernel/base/error.h"
#include "reports/wording/markdown_text.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

using Row = std::vector<std::string>;

// Plug-ins of both runs: whether they are the same files.
InstrumentTable plugins_table(const RunComparison& comparison) {
  InstrumentTable table{"Plug-ins, known by the name that they declare", {"name", "in OLD", "in NEW", "files"}, {}};
  for (const ComparedKernel& kernel : comparison.kernels) {
    if (kernel.before.empty() || kernel.after.empty() || !kernel.has_digests) continue;
    table.rows.push_back({kernel.name, kernel.before, kernel.after,
                          kernel.digest_change.empty() ? "the same" : "changed: " + kernel.digest_change});
  }
  return table;
}

// "12 of 65,536: 110 to 320 per million"; a maximum or a count of findings is shown as it is.
std::string figure_text(const Cell& cell) {
  if (cell.kind == Cell::Kind::finding) return thousands(cell.count());
  if (cell.kind == Cell::Kind::maximum) return error_amount(cell.figure);
  const std::uint64_t n = cell.independent, all = cell.of.trials;
  // The limits are those of the independent queries: the count is scaled down with them.
  const double share = all == 0 ? 0 : static_cast<double>(n) / static_cast<double>(all);
  const auto scaled = [&](bool up) {
    const double k = static_cast<double>(cell.of.failures) * share;
    return Proportion{std::min(n, static_cast<std::uint64_t>(up ? std::ceil(k) : std::floor(k))), n};
  };
  const double low = rate_limits(scaled(false)).first, high = rate_limits(scaled(true)).second;
  return fmt::format("{} of {}: {} to {}", thousands(cell.of.failures), thousands(all), amount(1e6 * low, 3),
                     amount(1e6 * high, 3));
}

std::string probability(const ComparedCell& cell) {
  if (cell.is_breach) return "a fault from the first on";
  if (cell.p_corrected) return fmt::format("{:.2g}", *cell.p_corrected);
  return cell.same_queries ? "same queries" : "";
}

InstrumentTable cells_table(const std::string& caption, const RunComparison& comparison, bool alarms) {
  InstrumentTable table{caption,
                        {"change", "kernel", "precision", "family", "cell", "OLD (95 % limits per million)",
                         "NEW (95 % limits per million)", "by chance, at most"},
                        {}};
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.change == Change::unchanged || cell.is_alarm() != alarms) continue;
    table.rows.push_back({std::string(name(cell.change)), cell.kernel(), cell.before.precision, cell.before.family,
                          cell.before.name(), figure_text(cell.before), figure_text(cell.after), probability(cell)});
  }
  return table;
}

InstrumentTable kernels_table(const RunComparison& comparison) {
  InstrumentTable table{
      "By kernel",
      {"kernel", "precision", "new", "worse", "better", "fixed", "unchanged", "wrong nowhere", "not looked at"},
      {}};
  constexpr std::size_t wrong_nowhere = change_names.size(), not_looked_at = wrong_nowhere + 1;
  std::vector<std::pair<std::pair<std::string, std::string>, std::array<std::uint64_t, not_looked_at + 1>>> rows;
  for (const ComparedCell& cell : comparison.cells) {
    const std::pair key(cell.kernel(), cell.before.precision);
    auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.first == key; });
    if (row == rows.end()) row = rows.insert(rows.end(), {key, {}});
    ++row->second[!cell.is_zero_in_both() ? index_of(cell.change)
                  : cell.is_looked_at()   ? wrong_nowhere
                                          : not_looked_at];
  }
  for (const auto& [key, counts] : rows) {
    Row row = {key.first, key.second};
    for (const std::uint64_t n : counts) row.push_back(thousands(n));
    table.rows.push_back(row);
  }
  return table;
}

// The outcomes for OLD's witnesses, those that are wrong now first; witnesses that behave as before are only counted.
InstrumentTable replay_table(const RunComparison& comparison) {
  InstrumentTable table{"Witnesses of OLD, evaluated again by the kernels here",
                        {"witness", "kernel", "precision", "family", "now", ""},
                        {}};
  for (const bool alarms : {true, false}) {
    for (const ReplayedQuery& r : comparison.replayed) {
      if (r.outcome == ReplayOutcome::as_before || r.is_alarm() != alarms) continue;
      table.rows.push_back({r.id, r.kernel, r.precision, r.family, std::string(name(r.outcome)), r.note});
    }
  }
  return table;
}

InstrumentTable promises_table(const RunComparison& comparison) {
  InstrumentTable table{"Promises", {"kernel", "precision", "promises", "how"}, {}};
  for (const ComparedPromise& promise : comparison.promises) {
    table.rows.push_back(
        {promise.kernel, promise.precision, promise.is_alarm() ? "less" : "other things", promise.change.text()});
  }
  return table;
}

// Those that fail come first.
InstrumentTable absent_table(const RunComparison& comparison) {
  InstrumentTable table{"NOT COMPARED", {"what", "why", "exit code"}, {}};
  constexpr EnumArray<Absence, const char*> codes = {"1", "allowed", "no fault", "no fault", "no fault"};
  for (const Absence absence : enumerators<Absence>) {
    for (const NotCompared& absent : comparison.not_compared) {
      if (absent.absence == absence) table.rows.push_back({absent.what, absent.why, codes[absence]});
    }
  }
  return table;
}

// A part of the first line: the first few of several sentences.
std::string few(const std::vector<std::string>& sentences) {
  constexpr std::size_t most = 3;
  const std::vector<std::string> first(
      sentences.begin(), sentences.begin() + static_cast<std::ptrdiff_t>(std::min(most, sentences.size())));
  return fmt::format("{}{}", fmt::join(first, "; "),
                     sentences.size() > most ? fmt::format("; {} more", sentences.size() - most) : "");
}

// "2 worse, 1 known witnesses wrong now": what was compared, in numbers.
std::vector<std::string> changes(const RunComparison& comparison) {
  std::vector<std::string> parts;
  for (const Change change : {Change::fresh, Change::worse, Change::better, Change::fixed}) {
    if (const std::size_t n = comparison.count(change))
      parts.push_back(fmt::format("{} {}", thousands(n), name(change)));
  }
  for (const ReplayOutcome outcome : {ReplayOutcome::wrong_now, ReplayOutcome::not_promised}) {
    const auto n = std::ranges::count(comparison.replayed, outcome, &ReplayedQuery::outcome);
    if (n != 0)
      parts.push_back(fmt::format("{} known witnesses {}", thousands(static_cast<std::size_t>(n)), name(outcome)));
  }
  return parts;
}

// The witnesses of NEW that show an alarm, each once, in the cells' order.
std::vector<const WitnessRecord*> new_witnesses(const ComparedRuns& runs, const RunComparison& comparison) {
  std::vector<const WitnessRecord*> found;
  for (const ComparedCell& cell : comparison.cells) {
    for (const std::string& id : cell.witnesses) {
      for (const WitnessRecord& witness : runs.after.witnesses) {
        if (witness.id == id && std::find(found.begin(), found.end(), &witness) == found.end())
          found.push_back(&witness);
      }
    }
  }
  return found;
}

InstrumentTable witness_table(const ComparedRuns& runs, const RunComparison& comparison) {
  InstrumentTable table{
      "Witnesses of NEW that show it", {"witness", "kernel", "exact", "computed", "reproduced by"}, {}};
  for (const WitnessRecord* w : new_witnesses(runs, comparison)) {
    table.rows.push_back({w->id, w->kernel, std::string(name(w->truth)), std::string(name(w->computed)),
                          replay_command(*w, runs.after.plan)});
  }
  return table;
}

std::string run_text(const char* which, const std::string& folder, const Record& record) {
  const std::string& version = record.plan.axiscert;
  return fmt::format("{}: {}, axiscert {}, seed {}{}", which, printable_line(folder), version, record.plan.seed.value,
                     record.complete ? "" : ", INTERRUPTED");
}

std::vector<std::string> notes(const ComparedRuns& runs, const RunComparison& comparison) {
  std::size_t same = 0;
  for (const ComparedCell& cell : comparison.cells) same += cell.same_queries;
  std::vector<std::string> notes = {run_text("OLD", runs.before_name, runs.before),
                                    run_text("NEW", runs.after_name, runs.after)};
  if (!comparison.replayed.empty()) {
    std::map<ReplayOutcome, std::size_t> by_outcome;
    for (const ReplayedQuery& r : comparison.replayed) ++by_outcome[r.outcome];
    std::vector<std::string> parts;
    for (const auto& [outcome, n] : by_outcome) {
      parts.push_back(fmt::format("{} {}", thousands(n), name(outcome)));
    }
    notes.push_back(fmt::format("Witnesses of OLD, evaluated again here: {}.", fmt::join(parts, ", ")));
  }
  notes.push_back(fmt::format(
      "{} cells, {} of them counts that could be compared. {} were counted over the same queries, where any difference "
      "counts. {} were counted over different "
      "queries: "
      "Fisher's exact test, two-sided, queries that share a triangle counted as one, and Holm's correction over these "
      "cells; two runs that differ in chance alone give an alarm in at most {:.0f} % of cases. Maxima are compared on "
      "the "
      "same queries only. Limits are Clopper and Pearson's, each alone, for this generator only.",
      thousands(comparison.cells.size()), thousands(comparison.compared()), thousands(same),
      thousands(comparison.tested), 100 * family_wise_error));
  return notes;
}

}  // namespace

std::string answer(const RunComparison& comparison) {
  std::vector<std::string> lesser;
  for (const ComparedPromise& promise : comparison.promises) {
    if (promise.is_alarm()) lesser.push_back(promise.text());
  }
  const std::vector<std::string> counts = changes(comparison);
  const bool is_worse = comparison.alarms() != 0;
  // The compared cells, in a word or in numbers.
  std::string change = counts.empty() ? (lesser.empty() ? "no change" : "worse")
                                      : fmt::format("{}: {}", is_worse ? "worse" : "better", fmt::join(counts, ", "));
  if (!lesser.empty()) change += fmt::format("{} {}", counts.empty() ? ":" : ";", few(lesser));

  const auto text = [&](Absence absence) {
    return absences_text(comparison.not_compared, absence, comparison.families);
  };
  std::string failing = text(Absence::fails);
  const bool is_nothing = comparison.compared() == 0;
  if (is_nothing) {
    failing =
        "nothing was compared: the two runs have no kernel, precision and family with the same promise and promised "
        "queries in common" +
        (failing.empty() ? "" : "; " + failing);
  }
  std::string line;
  if (failing.empty()) line = change;
  else if (is_worse) line = fmt::format("{}; NOT COMPARED: {}", change, failing);
  else if (is_nothing && counts.empty()) line = "NOT COMPARED: " + failing;
  else line = fmt::format("NOT COMPARED: {}; the rest: {}", failing, change);
  if (const std::string allowed = text(Absence::allowed); !allowed.empty())
    line += "; NOT COMPARED, as allowed: " + allowed;
  if (const std::string more = text(Absence::only_new); !more.empty()) line += "; only in NEW: " + more;
  return line;
}

InstrumentReport comparison_report(const ComparedRuns& runs, const RunComparison& comparison) {
  InstrumentReport report;
  report.name = "compare";
  report.title = "axiscert compare: " + answer(comparison);
  report.command = compare_command(runs.before_name, runs.after_name);
  for (const std::string& name : comparison.allowed) report.command += " --allow-not-compared " + shell_word(name);
  report.notes = notes(runs, comparison);
  report.add(promises_table(comparison));
  report.add(cells_table("New and worse", comparison, true));
  report.add(replay_table(comparison));
  report.add(witness_table(runs, comparison));
  report.add(cells_table("Better and fixed", comparison, false));
  report.add(kernels_table(comparison));
  report.add(plugins_table(comparison));
  report.add(absent_table(comparison));
  report.data = comparison_json(runs, comparison);
  return report;
}

std::string comparison_markdown(const ComparedRuns& runs, const RunComparison& comparison) {
  const InstrumentReport report = comparison_report(runs, comparison);
  std::string text = fmt::format("# {}\n", markdown_text(report.title));
  for (const std::string& note : report.notes) text += fmt::format("\n{}\n", markdown_text(note, 4000));
  for (const InstrumentTable& table : report.tables) {
    Section section(table.caption);
    section.add_head(table.columns, table.columns.size());
    for (const Row& row : table.rows) {
      Row cells;
      for (const std::string& cell : row) cells.push_back(markdown_text(cell, 400));
      section.add_row(cells);
    }
    text += section.text();
  }
  return text + "\n## How to reproduce\n\n" + code_block(report.command);
}

Json comparison_json(const ComparedRuns& runs, const RunComparison& comparison) {
  const auto run = [](const std::string& folder, const Record& record) {
    return ComparedRunData{printable_line(folder), record.plan.axiscert, {record.plan.seed.value}, record.complete};
  };
  ComparisonData data{.schema = {},
                      .before = run(runs.before_name, runs.before),
                      .after = run(runs.after_name, runs.after),
                      .answer = answer(comparison),
                      .passes = comparison.passes(),
                      .alarms = comparison.alarms(),
                      .family_wise_error = family_wise_error,
                      .tested = comparison.tested,
                      .compared = comparison.compared(),
                      .promises = comparison.promises,
                      .kernels = comparison.kernels,
                      .cells = {},
                      .replayed = comparison.replayed,
                      .not_compared = comparison.not_compared,
                      .new_witnesses = {}};
  for (const Change change : enumerators<Change>) data.counts[change] = comparison.count(change);
  for (const ComparedCell& cell : comparison.cells) {
    const Cell &before = cell.before, &after = cell.after;
    if (cell.is_zero_in_both()) {
      ++(cell.is_looked_at() ? data.wrong_nowhere : data.not_looked_at);
      continue;
    }
    data.cells.push_back({fingerprint(after.key()), cell.kernel(), before.precision, before.family, before.place,
                          before.member, cell.change, before.figure, after.figure, before.of.trials, after.of.trials,
                          cell.same_queries, cell.p, cell.p_corrected, cell.witnesses});
  }
  for (const WitnessRecord* witness : new_witnesses(runs, comparison)) data.new_witnesses.push_back(*witness);
  return json_of(data);
}

}  // namespace axiscert
