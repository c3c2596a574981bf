// `axiscert mutate --verdict-only`: which faults a gate refuses in a kernel that shows its verdict alone, and why it
// lets the others pass.
#include "reports/instrument/black_box_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

using namespace black_box;

class BlackBoxReport {
 public:
  BlackBoxReport(const MutationPlan& plan, const BlackBoxScore& score) : plan_(plan), score_(score) {}

  InstrumentReport report(const std::string& require, const std::string& command) const {
    InstrumentReport report{
        "mutation-by-verdict",
        fmt::format("{} mutants of {} that show their verdict alone: what `--require {}` refuses{}",
                    plan_.mutants.size(), plan_.base, require, score_.complete ? "" : " (interrupted)"),
        command,
        {fmt::format(
             "A mutant is the kernel with one fault, judged as a plug-in that shows nothing but its verdict. It is "
             "refused where `run --require {}` on the first {} queries of each family would not be met.",
             require, thousands(plan_.trials)),
         "A fault of a magnitude E is an epsilon, a clamp, a threshold or an early answer; `relative`: E is a fraction "
         "of the value, or of the scene.",
         "A survivor is compared with the kernel without the fault, verdict by verdict, on the same queries: that is "
         "its reason. The deepest of the wrong ones is of the first four in each family and batch of queries."},
        {scores(), by_magnitude(), by_fault(), survivors(), controls()},
        {},
        black_box_json(plan_, score_, require, command)};
    if (plan_.trials < least_looked_at) {
      report.title = "NOT CHECKED, too few queries: " + report.title;
      report.notes.insert(
          report.notes.begin(),
          fmt::format("NOT CHECKED: a level takes {} queries of each family, and {} were asked: a mutant "
                      "that survived, or a kernel that is not refused, was not looked at.",
                      least_looked_at, plan_.trials));
    }
    if (score_.complete && std::ranges::any_of(score_.mutants, is_not_judged)) {
      report.is_of_nothing = true;
      report.title = "Nothing was judged, no query is valid: " + report.title;
    }
    std::erase_if(report.tables, [](const InstrumentTable& table) { return table.rows.empty(); });
    return report;
  }

 private:
  static void add_cells(std::vector<std::string>& row, const std::vector<std::string>& cells) {
    row.insert(row.end(), cells.begin(), cells.end());
  }

  template <class Of>
  BoxScore score_of(const Of& of) const {
    BoxScore score;
    for (const BlackBoxResult& r : score_.mutants) {
      if (of(r)) score.add(r);
    }
    return score;
  }

  InstrumentTable scores() const {
    InstrumentTable table{"Score", {"precision", "mutants of", "mutants", "equivalent", "refused", "survived"}, {}};
    for (const Precision precision : plan_.precisions) {
      for (const bool of_magnitude : {false, true}) {
        const BoxScore score = score_of(
            [&](const BlackBoxResult& r) { return r.precision == precision && has_magnitude(r) == of_magnitude; });
        if (score.mutants == 0) continue;
        std::vector<std::string> row = {std::string(name(precision)),
                                        of_magnitude ? "a value, by a magnitude" : "operations and comparisons"};
        add_cells(row, score.cells());
        table.rows.push_back(std::move(row));
      }
    }
    return table;
  }

  std::vector<double> magnitudes() const {
    std::vector<double> all;
    for (const BlackBoxResult& r : score_.mutants) {
      if (has_magnitude(r) && std::find(all.begin(), all.end(), r.mutant->magnitude) == all.end())
        all.push_back(r.mutant->magnitude);
    }
    std::sort(all.rbegin(), all.rend());
    return all;
  }

  std::vector<std::string> faults() const {
    std::vector<std::string> all;
    for (const BlackBoxResult& r : score_.mutants) {
      if (std::find(all.begin(), all.end(), r.mutant->fault) == all.end()) all.push_back(r.mutant->fault);
    }
    return all;
  }

  // "5 of 7", without the equivalent ones; both precisions.
  InstrumentTable by_magnitude() const {
    InstrumentTable table{"Refused, by magnitude", {"fault", "what"}, {}};
    const std::vector<double> columns = magnitudes();
    for (const double magnitude : columns) table.columns.push_back(fmt::format("E = {}", magnitude));
    for (const std::string& fault : faults()) {
      std::vector<std::string> row = {fault, ""};
      for (const double magnitude : columns) {
        const BoxScore score = score_of([&](const BlackBoxResult& r) {
          const bool is_of = has_magnitude(r) && r.mutant->fault == fault && r.mutant->magnitude == magnitude;
          if (is_of) row[1] = r.mutant->what;
          return is_of;
        });
        const std::uint64_t distinct = score.mutants - score.equivalent - score.not_judged;
        row.push_back(distinct == 0 ? "-" : fmt::format("{} of {}", score.refused, distinct));
      }
      if (!row[1].empty()) table.rows.push_back(std::move(row));
    }
    return table;
  }

  InstrumentTable by_fault() const {
    InstrumentTable table{
        "By fault", {"fault", "what", "precision", "mutants", "equivalent", "refused", "survived"}, {}};
    for (const std::string& fault : faults()) {
      for (const Precision precision : plan_.precisions) {
        std::string what;
        const BoxScore score = score_of([&](const BlackBoxResult& r) {
          const bool is_of = !has_magnitude(r) && r.precision == precision && r.mutant->fault == fault;
          if (is_of) what = r.mutant->what;
          return is_of;
        });
        if (score.mutants == 0) continue;
        std::vector<std::string> row = {fault, what, std::string(name(precision))};
        add_cells(row, score.cells());
        table.rows.push_back(std::move(row));
      }
    }
    return table;
  }

  // Those with one fault, at one place where it has a magnitude, and one reason share a row.
  InstrumentTable survivors() const {
    struct Row {
      std::vector<const BlackBoxResult*> all;
      const BlackBoxResult* deepest = nullptr;
    };
    std::map<std::tuple<std::size_t, std::string, std::size_t, std::string>, Row> rows;
    const std::vector<std::string> order = faults();
    for (const BlackBoxResult& r : score_.mutants) {
      if (!has_survived(r) || !r.survival || is_not_judged(r)) continue;
      const auto fault =
          static_cast<std::size_t>(std::find(order.begin(), order.end(), r.mutant->fault) - order.begin());
      const std::string place = has_magnitude(r) ? r.mutant->id.substr(0, r.mutant->id.rfind(':')) : "";
      Row& row = rows[{fault, place, index_of(r.precision), reason_of(r).sentence}];
      row.all.push_back(&r);
      if (row.deepest == nullptr || r.survival->depth() > row.deepest->survival->depth()) row.deepest = &r;
    }
    InstrumentTable table{"Survived", {"mutants", "precision", "which", "reason", "wrong verdicts", "deepest"}, {}};
    for (const auto& [key, row] : rows) {
      const BlackBoxResult& r = *row.deepest;
      std::vector<std::string> which;
      std::uint64_t wrong = 0;
      for (const BlackBoxResult* one : row.all) {
        which.push_back(has_magnitude(*one) ? fmt::format("{}", one->mutant->magnitude) : one->mutant->id);
        wrong = std::max(wrong, one->survival->wrong);
      }
      constexpr std::size_t most = 3;
      const std::string list =
          fmt::format(
              "{}", fmt::join(which.begin(), which.begin() + static_cast<std::ptrdiff_t>(std::min(most, which.size())),
                              ", ")) +
          (which.size() > most ? fmt::format(" and {} more", which.size() - most) : "");
      const auto& place = std::get<1>(key);
      table.rows.push_back(
          {thousands(row.all.size()), std::string(name(r.precision)),
           has_magnitude(r) ? fmt::format("{}, E = {}", place, fmt::join(which, ", ")) : list, reason_of(r).sentence,
           wrong == 0 ? "0" : fmt::format("{}{}", row.all.size() == 1 ? "" : "up to ", thousands(wrong)),
           !r.survival->deepest
               ? "-"
               : fmt::format("{} on {}", amount(r.survival->depth(), 3), r.survival->deepest->family->name)});
    }
    return table;
  }

  InstrumentTable controls() const {
    InstrumentTable table{"Kernels that are right", {"kernel", "precision", "refused"}, {}};
    for (const BlackBoxControl& c : score_.controls) {
      const bool is_unjudged = std::ranges::any_of(
          score_.mutants, [&](const BlackBoxResult& r) { return r.precision == c.precision && is_not_judged(r); });
      table.rows.push_back({c.id, std::string(name(c.precision)),
                            c.refused     ? fmt::format("{}: {}", c.refused->family, c.refused->what)
                            : is_unjudged ? "not judged"
                                          : "no"});
    }
    return table;
  }

  const MutationPlan& plan_;
  const BlackBoxScore& score_;
};

}  // namespace

std::vector<std::string> black_box_faults(const BlackBoxScore& score) {
  std::vector<std::string> faults;
  const auto add = [&](const std::string& kernel, Precision precision, const GateFailure& failure, const char* why) {
    faults.push_back(
        fmt::format("{} {} is refused ({}: {}), but {}", kernel, name(precision), failure.family, failure.what, why));
  };
  for (const BlackBoxResult& r : score.mutants) {
    if (r.refused && is_equivalent(r))
      add(r.mutant->id, r.precision, *r.refused, "nothing distinguishes it from a kernel that is right");
  }
  for (const BlackBoxControl& c : score.controls) {
    if (c.refused) add(c.id, c.precision, *c.refused, "it is right");
  }
  return faults;
}

InstrumentReport black_box_report(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                                  const std::string& command) {
  return BlackBoxReport(plan, score).report(require, command);
}

// mutation-by-verdict.json.

namespace {

using namespace black_box;

std::optional<FailureData> failure_data(const std::optional<GateFailure>& failure) {
  return failure ? std::optional(FailureData{failure->family, failure->what}) : std::nullopt;
}

std::optional<SurvivalData> survival_data(const MutationPlan& plan, const BlackBoxResult& r) {
  if (!r.survival || r.refused) return std::nullopt;
  SurvivalData survival{*r.survival, {}};
  if (const auto& deepest = r.survival->deepest) {
    const SourcePtr source = family_source(*deepest->family);
    survival.deepest = {deepest->family->name, text(address_of(*source, plan.seed, r.precision, deepest->position)),
                        deepest->depth};
  }
  return survival;
}

}  // namespace

Json black_box_json(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                    const std::string& command) {
  MutationByVerdictData data;
  data.command = command;
  data.run = run_data(plan, score.complete, require);
  for (const Precision precision : plan.precisions) {
    BoxScore of_precision;
    for (const BlackBoxResult& r : score.mutants) {
      if (r.precision == precision) of_precision.add(r);
    }
    data.score[precision] = of_precision;
  }
  for (const BlackBoxResult& r : score.mutants) {
    const bool has_reason = !r.refused && (r.survival || is_equivalent(r));
    data.mutants.push_back({mutant_data(*r.mutant, r.precision),
                            has_magnitude(r) ? std::optional(r.mutant->magnitude) : std::nullopt, r.trials,
                            failure_data(r.refused), has_reason ? std::optional<Name>(reason_of(r).id) : std::nullopt,
                            survival_data(plan, r)});
  }
  for (const BlackBoxControl& c : score.controls) data.controls.push_back({c.id, c.precision, failure_data(c.refused)});
  return json_of(data);
}

}  // namespace axiscert
