// `axiscert mutate`: which of the faults planted in a kernel the harness catches, and how soon.
#include "reports/instrument/mutation_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

constexpr std::uint64_t soon = 10'000;  // queries

// The argument that nothing distinguishes the mutant from its base; null where something should.
const std::string* equivalence_of(const MutantResult& r) {
  const auto found = equivalent_mutants().find(r.mutant->id);
  return found == equivalent_mutants().end() ? nullptr : &found->second;
}

// Counts of mutants; those not equivalent to their base are counted as caught, caught soon, or caught by formulae
// alone; not judged where no query was valid.
struct Score {
  bool is_judged = true, is_judged_by_formulae = true;
  std::uint64_t mutants = 0, equivalent = 0, caught = 0, soon = 0, by_formulae = 0;
  std::vector<std::uint64_t> queries;

  void add(const MutantResult& r) {
    ++mutants;
    if (equivalence_of(r)) {
      ++equivalent;
      return;
    }
    by_formulae += r.by_formulae.has_value();
    if (!r.by_bits) return;
    ++caught;
    soon += r.by_bits->queries <= axiscert::soon;
    queries.push_back(r.by_bits->queries);
  }
  std::uint64_t not_caught() const { return mutants - equivalent - caught; }
  // Number of queries after which at least half of the mutants that are not equivalent are caught.
  std::optional<std::uint64_t> median() const {
    const std::uint64_t all = mutants - equivalent;
    if (all == 0 || caught * 2 < all) return std::nullopt;
    std::vector<std::uint64_t> sorted = queries;
    std::sort(sorted.begin(), sorted.end());
    return sorted[(all - 1) / 2];
  }
  std::vector<std::string> cells() const {
    if (!is_judged) return {thousands(mutants), thousands(equivalent), "-", "not judged", "-", "-", "-", "-"};
    const auto middle = median();
    const auto last = std::max_element(queries.begin(), queries.end());
    return {thousands(mutants),
            thousands(equivalent),
            thousands(caught),
            thousands(not_caught()),
            thousands(soon),
            middle ? thousands(*middle) : "-",
            last == queries.end() ? "-" : thousands(*last),
            is_judged_by_formulae ? thousands(by_formulae) : "-"};
  }
  CatchScoreData data() const {
    return {mutants,
            equivalent,
            caught,
            is_judged ? not_caught() : 0,
            is_judged ? 0 : not_caught(),
            soon,
            median(),
            is_judged_by_formulae ? std::optional(by_formulae) : std::nullopt};
  }
};

class MutationReport {
 public:
  MutationReport(const MutationPlan& plan, const MutationResult& result, const std::vector<Control>& controls)
      : plan_(plan), result_(result), controls_(controls) {}

  InstrumentReport report(const std::string& command, bool whole) const {
    InstrumentReport report{
        "mutation",
        fmt::format("{}{} mutants of {}: what `--require {}` catches{}", nothing_judged(), plan_.mutants.size(),
                    plan_.base, level_of_mutation, result_.complete ? "" : " (interrupted)"),
        command,
        {"A mutant is the kernel with one fault. It is caught by the first wrong verdict with a broken "
         "implementation link; `queries` counts all queries up to then, of all families in "
         "turn, 251 of each. Every catch is confirmed by all oracles.",
         "Formulae alone: the same mutant where it claims the formulae and not their bits, as a kernel "
         "of one's own may: caught by a wrong verdict where arithmetic is exact, touching ones not counted. A fault "
         "that only changes rounding is not a fault there.",
         "Equivalent: fuzz/instruments/equivalent_mutants.txt argues that no query distinguishes it from the kernel; "
         "it was run on as many queries as the others."},
        {scores(), by_fault(), by_family(), not_caught(), controls()},
        {},
        data(command)};
    report.is_of_nothing = !nothing_judged().empty();
    if (whole) report.tables.push_back(all());
    std::erase_if(report.tables, [](const InstrumentTable& table) { return table.rows.empty(); });
    return report;
  }

 private:
  static std::vector<std::string> score_columns(std::vector<std::string> first) {
    for (const char* column : {"mutants", "equivalent", "caught", "survived", "within 10^4", "median queries",
                               "most queries", "caught, formulae alone"}) {
      first.emplace_back(column);
    }
    return first;
  }
  static void add_row(InstrumentTable& table, std::vector<std::string> first, const std::vector<std::string>& cells) {
    first.insert(first.end(), cells.begin(), cells.end());
    table.rows.push_back(std::move(first));
  }
  bool is_judged(Precision precision) const { return result_.judged.contains(precision); }
  // The title begins so where no query of a precision was valid.
  std::string nothing_judged() const {
    std::vector<std::string_view> precisions;
    for (const Precision precision : plan_.precisions) {
      if (!is_judged(precision)) precisions.push_back(name(precision));
    }
    if (precisions.empty() || !result_.complete) return "";
    return fmt::format("Nothing was judged in {}, no query is valid: ", fmt::join(precisions, " and "));
  }
  Score score(Precision precision, const std::string& fault = "") const {
    Score score;
    score.is_judged = is_judged(precision);
    score.is_judged_by_formulae = std::ranges::any_of(
        plan_.families, [](const Family* one) { return shows_formulae(one->name, one->exact_arithmetic); });
    for (const MutantResult& r : result_.mutants) {
      if (r.precision == precision && (fault.empty() || r.mutant->fault == fault)) score.add(r);
    }
    return score;
  }

  InstrumentTable scores() const {
    InstrumentTable table{"Score", score_columns({"precision"}), {}};
    for (const Precision precision : plan_.precisions) {
      add_row(table, {std::string(name(precision))}, score(precision).cells());
    }
    return table;
  }

  InstrumentTable by_fault() const {
    InstrumentTable table{"By fault", score_columns({"fault", "what", "precision"}), {}};
    std::vector<std::string> faults;
    for (const mutants::Mutant* m : plan_.mutants) {
      if (std::find(faults.begin(), faults.end(), m->fault) != faults.end()) continue;
      faults.push_back(m->fault);
      for (const Precision precision : plan_.precisions) {
        const Score of_fault = score(precision, m->fault);
        if (of_fault.mutants > 0) add_row(table, {m->fault, m->what, std::string(name(precision))}, of_fault.cells());
      }
    }
    return table;
  }

  InstrumentTable by_family() const {
    InstrumentTable table{"First caught by", {"family"}, {}};
    for (const Precision precision : plan_.precisions) table.columns.emplace_back(name(precision));
    for (const Family* family : plan_.families) {
      std::vector<std::string> row = {std::string(family->name)};
      for (const Precision precision : plan_.precisions) {
        row.push_back(!is_judged(precision)
                          ? "-"
                          : thousands(static_cast<std::uint64_t>(std::count_if(
                                result_.mutants.begin(), result_.mutants.end(), [&](const MutantResult& r) {
                                  return r.precision == precision && r.by_bits && r.by_bits->family == family;
                                }))));
      }
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  InstrumentTable not_caught() const {
    InstrumentTable table{"Not caught", {"mutant", "precision", "where", "what", "argued equivalent"}, {}};
    for (const MutantResult& r : result_.mutants) {
      if (r.by_bits) continue;
      const std::string* equivalent = equivalence_of(r);
      table.rows.push_back({r.mutant->id, std::string(name(r.precision)), r.mutant->where, r.mutant->what,
                            equivalent               ? *equivalent
                            : is_judged(r.precision) ? "no: it survived"
                                                     : "not judged"});
    }
    return table;
  }

  InstrumentTable controls() const {
    InstrumentTable table{
        "Correct kernels that are written in another way",
        {"kernel", "precision", "claims", "queries", fmt::format("wrong verdicts against `{}`", level_of_mutation)},
        {}};
    for (const Control& c : controls_) {
      table.rows.push_back({c.id, std::string(name(c.precision)), c.claims_bits ? "its bits" : "formulae alone",
                            thousands(c.queries), c.queries == 0 ? "not judged" : thousands(c.flagged)});
    }
    return table;
  }

  const MutantResult* find(const mutants::Mutant* mutant, Precision precision) const {
    for (const MutantResult& r : result_.mutants) {
      if (r.mutant == mutant && r.precision == precision) return &r;
    }
    return nullptr;
  }

  InstrumentTable all() const {
    InstrumentTable table{"Every mutant", {"mutant", "where", "what"}, {}};
    for (const Precision precision : plan_.precisions) {
      table.columns.push_back(fmt::format("{}: family", name(precision)));
      table.columns.emplace_back("queries");
      table.columns.emplace_back("formulae alone");
    }
    const auto queries = [](const std::optional<Catch>& found) { return found ? thousands(found->queries) : "-"; };
    for (const mutants::Mutant* mutant : plan_.mutants) {
      std::vector<std::string> row = {mutant->id, mutant->where, mutant->what};
      for (const Precision precision : plan_.precisions) {
        const MutantResult* r = find(mutant, precision);
        if (!r) row.insert(row.end(), {"", "", ""});
        else if (r->by_bits)
          row.insert(row.end(), {std::string(r->by_bits->family->name), queries(r->by_bits), queries(r->by_formulae)});
        else {
          const char* not_caught = is_judged(precision) ? "survived" : "not judged";
          row.insert(row.end(), {equivalence_of(*r) ? "equivalent" : not_caught, "-", "-"});
        }
      }
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  std::optional<CatchData> catch_data(const MutantResult& r, const std::optional<Catch>& found) const {
    if (!found) return std::nullopt;
    const SourcePtr source = family_source(*found->family);
    return CatchData{found->family->name, found->queries,
                     text(address_of(*source, plan_.seed, r.precision, found->position)), found->kind, found->depth};
  }

  Json data(const std::string& command) const {
    MutationData data;
    data.command = command;
    data.run = run_data(plan_, result_.complete, level_of_mutation);
    for (const Precision precision : plan_.precisions) data.score[precision] = score(precision).data();
    for (const MutantResult& r : result_.mutants) {
      const std::string* equivalent = equivalence_of(r);
      data.mutants.push_back({mutant_data(*r.mutant, r.precision), catch_data(r, r.by_bits),
                              catch_data(r, r.by_formulae),
                              equivalent ? std::optional<Name>(*equivalent) : std::nullopt});
    }
    for (const Control& c : controls_)
      data.controls.push_back({c.id, c.precision, c.claims_bits ? "bits" : "formulae", c.queries, c.flagged});
    return json_of(data);
  }

  const MutationPlan& plan_;
  const MutationResult& result_;
  const std::vector<Control>& controls_;
};

}  // namespace

MutationRunData run_data(const MutationPlan& plan, bool complete, const std::string& require) {
  MutationRunData run{complete, plan.base, require, {plan.seed}, plan.trials, {}};
  for (const Family* family : plan.families) run.families.push_back(family->name);
  return run;
}

std::vector<std::string> mutation_faults(const MutationResult& result, const std::vector<Control>& controls) {
  std::vector<std::string> faults;
  for (const MutantResult& r : result.mutants) {
    const std::string* equivalent = equivalence_of(r);
    if (!equivalent) continue;
    const auto add = [&](const char* what) {
      faults.push_back(fmt::format(
          "{} {}: fuzz/instruments/equivalent_mutants.txt argues that nothing distinguishes it from its base, but {}",
          r.mutant->id, name(r.precision), what));
    };
    if (r.by_bits) add("a query does so");
    else if (!r.same_bits) add("its comparisons differ");
  }
  for (const Control& c : controls) {
    if (c.flagged == 0) continue;
    faults.push_back(fmt::format("{} {} is right, and {} of its verdicts count against `{}`", c.id, name(c.precision),
                                 c.flagged, level_of_mutation));
  }
  return faults;
}

InstrumentReport mutation_report(const MutationPlan& plan, const MutationResult& result,
                                 const std::vector<Control>& controls, const std::string& command, bool whole) {
  return MutationReport(plan, result, controls).report(command, whole);
}

std::string instrument_markdown(const InstrumentReport& report) {
  std::string text = fmt::format("# {}\n\n{}", report.title, code_block(report.command));
  for (const InstrumentTable& table : report.tables) {
    text += fmt::format("\n## {}\n\n| {} |\n|", table.caption, fmt::join(table.columns, " | "));
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const bool numbers = std::all_of(table.rows.begin(), table.rows.end(), [i](const std::vector<std::string>& row) {
        return row[i].size() <= 1 || is_number(row[i]);
      });
      text += numbers ? " ---: |" : " --- |";
    }
    text += "\n";
    for (const auto& row : table.rows) {
      text += "|";
      for (const std::string& cell : row) text += " " + markdown_text(cell, 400) + " |";
      text += "\n";
    }
  }
  for (const std::string& note : report.notes) text += "\n" + note + "\n";
  return text;
}

}  // namespace axiscert
