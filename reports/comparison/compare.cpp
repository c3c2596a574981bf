#include "reports/comparison/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "fuzz/queries/source.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "reports/comparison/pairing.h"
#include "reports/comparison/shown.h"
#include "reports/wording/evidence.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

Change direction(const Cell& before, const Cell& after, bool grew) {
  if (grew) return before.is_zero() ? Change::fresh : Change::worse;
  return after.is_zero() ? Change::fixed : Change::better;
}

// That of a cell which has one.
Precision precision_of_name(const std::string& text) {
  return text == name(Precision::binary32) ? Precision::binary32 : Precision::binary64;
}
// Whether a record has a kernel in the precision of a cell, which a finding of loading does not have.
bool has_entry(const Record& record, const std::string& id, const std::string& precision) {
  return !precision.empty() && precision_entry(record, id, precision_of_name(precision)) != nullptr;
}

// By kernel (its id in OLD), precision and family.
using FamilyOfKernel = std::array<std::string, 3>;

class Comparer {
 public:
  Comparer(const Record& before, const Record& after)
      : before_(before), after_(after), pairs_(before, after), unloaded_(not_judged(after)) {}

  RunComparison run(std::vector<ReplayedQuery> replayed, const std::vector<std::string>& allowed) {
    result_.families = before_.plan.families.size();
    note_runs();
    note_kernels();
    for (const ComparedKernel& kernel : pairs_.all()) {
      if (kernel.is_in_both() && !is_unloaded(kernel)) compare_promises(kernel);
    }
    compare_cells();
    correct();
    name_witnesses();
    note_kernels_without_cells();
    allow(result_.not_compared, allowed);
    result_.allowed = allowed;
    result_.kernels = std::move(pairs_.all());
    result_.replayed = std::move(replayed);
    return std::move(result_);
  }

 private:
  bool is_unloaded(const ComparedKernel& kernel) const { return contains(unloaded_, kernel.after); }
  static bool contains(const std::vector<std::string>& all, const std::string& one) {
    return std::ranges::find(all, one) != all.end();
  }

  // Each thing once: the first reason stands. Two kernels may have had one id, as NEW's that could not be loaded.
  void note(NotCompared absent) {
    if (said_.insert(absent.what + (absent.kernels.empty() ? "" : "\n" + absent.kernels.front())).second)
      result_.not_compared.push_back(std::move(absent));
  }
  void note(const std::string& who, const std::string& why, const ComparedKernel& kernel,
            Absence absence = Absence::fails) {
    note({who, why, kernel.names(), "", absence});
  }

  void note_runs() {
    for (const auto& [run, record] : {std::pair("OLD", &before_), {"NEW", &after_}}) {
      if (!record->complete)
        note({run, "is INTERRUPTED: what it lacks cannot be told from what is right", {}, "", Absence::fails});
    }
    const std::vector<Name>&then = before_.plan.families, &now = after_.plan.families;
    const auto note_missing = [&](const std::vector<Name>& from, const std::vector<Name>& in, const char* why,
                                  Absence absence) {
      for (const Name& family : from) {
        if (std::ranges::find(in, family) != in.end()) continue;
        note({family, why, {}, family, absence});
        lost_.insert(family);
      }
    };
    note_missing(then, now, "is only in OLD", Absence::fails);
    note_missing(now, then, "is only in NEW", Absence::only_new);
    for (const FileRecord& file : after_.plan.files) {
      const auto old = std::ranges::find_if(before_.plan.files, [&](const FileRecord& other) {
        return other.family_name() == file.family_name() && other.sha256 == file.sha256;
      });
      if (old == before_.plan.files.end() || !old->left_out || !file.left_out) continue;
      const std::string family = file.family_name();
      for (const auto& [precision, count] : *file.left_out) {
        if (!old->left_out->contains(precision)) continue;
        note({fmt::format("{} in {}", family, name(precision)),
              fmt::format("neither run was to ask its {} queries", thousands(count)),
              {},
              family,
              Absence::empty});
      }
    }
  }

  void note_kernels() {
    for (const ComparedKernel& kernel : pairs_.all()) {
      if (!kernel.after.empty() && is_unloaded(kernel))
        note(kernel.after, "could not be loaded in NEW, so it was not judged", kernel);
      else if (kernel.before.empty())
        note(kernel.after, "is only in NEW" + pairs_.reason(kernel), kernel, Absence::only_new);
      else if (kernel.after.empty()) note(kernel.before, "is only in OLD" + pairs_.reason(kernel), kernel);
      else if (contains(not_judged(before_), kernel.before)) note(kernel.before, "could not be loaded in OLD", kernel);
      else note_given_by_one(before_, after_, kernel, result_.not_compared);
    }
  }

  // Compares what a kernel that both runs judged promises in each precision, and over how many queries of each family.
  void compare_promises(const ComparedKernel& kernel) {
    for (const KernelRecord* now : precision_entries(after_, kernel.after)) {
      if (precision_entry(before_, kernel.before, now->precision) == nullptr)
        note(fmt::format("{} {}", kernel.after, name(now->precision)), "is only in NEW", kernel, Absence::only_new);
    }
    for (const KernelRecord* then : precision_entries(before_, kernel.before)) {
      const std::string precision(name(then->precision)), who = fmt::format("{} {}", kernel.before, precision);
      const KernelRecord* const now = precision_entry(after_, kernel.after, then->precision);
      if (now == nullptr) {
        note_lost(kernel, then->precision, who);
        continue;
      }
      if (const Evidence evidence = evidence_of(*now); evidence.population != 0 && evidence.decided() == 0)
        note(who, "decided none of its promised queries in NEW", kernel);
      const PromiseChange change = change_of(promise_in(*then), promise_in(*now));
      if (change.is_none()) {
        compare_populations(kernel, *then, *now);
        compare_shown(kernel, *then, *now);
        continue;
      }
      for (const auto& [family, result] : then->families) apart_.insert({kernel.before, precision, family});
      for (const auto& [family, result] : now->families) apart_.insert({kernel.before, precision, family});
      // A promise of less is said as worse.
      const std::string how = change.less.empty() ? fmt::format(" ({})", change.text()) : "";
      note(who, populations(evidence_of(*then), evidence_of(*now)) + how, kernel);
      result_.promises.push_back({kernel.name, precision, change});
    }
  }

  void note_lost(const ComparedKernel& kernel, Precision precision, const std::string& who) {
    const std::vector<Precision>& asked = after_.plan.precisions;
    if (std::ranges::find(asked, precision) == asked.end())
      return note(who, fmt::format("is only in OLD: NEW was not run in {}", name(precision)), kernel);
    note(who, "is only in OLD", kernel);
    result_.promises.push_back({kernel.name,
                                std::string(name(precision)),
                                {{fmt::format("it does not exist in {} any more", name(precision))}, {}}});
  }

  static std::string populations(const Evidence& then, const Evidence& now) {
    return fmt::format("counts over other promised queries: {} of OLD, {} of NEW", thousands(then.promised()),
                       thousands(now.promised()));
  }

  void compare_populations(const ComparedKernel& kernel, const KernelRecord& then, const KernelRecord& now) {
    const std::string precision(name(then.precision));
    for (const auto& [family, result] : then.families) {
      const FamilyRecord* const other = now.families.find(family);
      if (other == nullptr) continue;
      const Evidence old = evidence_of(then, result), fresh = evidence_of(now, *other);
      if (old.promised() == fresh.promised() && fresh.promised() != 0) continue;
      const bool are_same = has_same_queries(family, then.precision);
      // Too few show no difference, whatever they are.
      const bool are_few =
          fresh.promised() < std::min(least_looked_at, old.promised()) && other->trials < result.trials;
      if (!are_same && !are_few && old.promised() != 0 && fresh.promised() != 0) continue;
      apart_.insert({kernel.before, precision, family});
      NotCompared absent{fmt::format("{} {} on {}", kernel.before, precision, family), populations(old, fresh),
                         kernel.names(), family, Absence::fails};
      if (old.promised() == 0 && fresh.promised() == 0) {
        absent.why = "no promised query in either run";
        absent.absence = Absence::empty;
      } else if (old.promised() == 0 && !are_same) {
        absent.why = "no promised query in OLD";
        absent.absence = Absence::only_new;
      } else if (!are_same) {
        absent.why = fmt::format("{} promised queries in NEW, {} in OLD: too few to show a difference",
                                 thousands(fresh.promised()), thousands(old.promised()));
      }
      note(std::move(absent));
    }
  }

  // Numbers that do not stand beside all answers any more that had them.
  void compare_shown(const ComparedKernel& kernel, const KernelRecord& then, const KernelRecord& now) {
    const std::string precision(name(then.precision));
    for (const auto& [family, result] : then.families) {
      const FamilyRecord* const other = now.families.find(family);
      if (other == nullptr) continue;
      const bool are_same = has_same_queries(family, then.precision);
      for (const Hidden& hidden : hidden_since(shown_in(result), shown_in(*other), are_same)) {
        if (hidden.kind == Hiding::gone) continue;  // which is said of the kernel
        hidden_.insert({kernel.before, precision, family, hidden.name});
        note({fmt::format("{} {} on {}: {}", kernel.before, precision, family, hidden.name), hidden.text,
              kernel.names(), family, hidden.kind == Hiding::verdicts ? Absence::verdicts : Absence::fails});
      }
    }
  }

  void compare_cells() {
    const auto key = [&](const Cell& cell, bool is_before) {
      return cell.key_of(pairs_.identity(cell.kernel, is_before));
    };
    std::map<Json, Cell> in_after;
    for (Cell& cell : cells_of(after_)) in_after.emplace(key(cell, false), std::move(cell));
    for (Cell& cell : cells_of(before_)) {
      const auto match = in_after.extract(key(cell, true));
      if (!match.empty()) add(std::move(cell), std::move(match.mapped()));
      else if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), false);
      else note_absent(cell, true, "is only in OLD", Absence::fails);
    }
    // A record has a cell for a finding only where there was one.
    for (Cell& cell : cells_of(after_)) {
      if (in_after.count(key(cell, false)) == 0) continue;
      if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), true);
      else note_absent(cell, false, "is only in NEW", Absence::only_new);
    }
  }

  bool is_apart(const Cell& cell, bool is_before) {
    return apart_.contains({pairs_.of(cell, is_before).before, cell.precision, cell.family});
  }

  // Reports a missing family, kernel or precision once, not once for each cell. A family's verdict comes first.
  void note_absent(const Cell& cell, bool is_before, const std::string& why, Absence absence) {
    const ComparedKernel& kernel = pairs_.of(cell, is_before);
    if (!kernel.is_in_both() || lost_.contains(cell.family) || is_apart(cell, is_before)) return;
    const Record& other = is_before ? after_ : before_;
    if (!has_entry(other, is_before ? kernel.after : kernel.before, cell.precision)) return;
    const std::string family = fmt::format("{} {} on {}", cell.kernel, cell.precision, cell.family);
    for (const std::string& whole : {family, family + ": comparisons"}) {
      if (said_.contains(whole + "\n" + kernel.name)) return;
    }
    const bool is_whole = cell.place == "verdict" || cell.kind == Cell::Kind::finding;
    const std::string part = is_whole                                               ? ""
                             : cell.is_of_contacts()                                ? ": contacts"
                             : cell.member == "tolerance_failures"                  ? ": " + cell.name()
                             : is_error_in_u(cell) || cell.member == "range_events" ? ": errors in u"
                                                                                    : ": comparisons";
    note({family + part, why, kernel.names(), cell.family, absence});
  }

  void add_finding(Cell cell, bool is_new) {
    // Chance cannot explain a finding. What NEW did not ask its kernel, or not to the end, has not been mended.
    if (!is_new && !is_asked_in_new(cell)) return;
    Cell none = cell;
    none.figure = 0;
    ComparedCell compared{is_new ? none : cell, is_new ? cell : none};
    compared.change = is_new ? Change::fresh : Change::fixed;
    result_.cells.push_back(std::move(compared));
  }

  bool is_asked_in_new(const Cell& cell) {
    const ComparedKernel& kernel = pairs_.of(cell, true);
    if (kernel.after.empty() || is_unloaded(kernel) || !after_.complete) return false;
    if (cell.precision.empty()) return true;
    const KernelRecord* const entry = precision_entry(after_, kernel.after, precision_of_name(cell.precision));
    return entry != nullptr && (cell.family.empty() || entry->families.contains(cell.family));
  }

  bool has_same_queries(const std::string& family, Precision precision) const {
    const Json mine = queries_of(before_.plan, family, precision);
    return !mine.is_null() && mine == queries_of(after_.plan, family, precision);
  }

  static std::string tolerance_of(const Record& record, const Cell& cell) {
    const auto* tolerance = record.plan.tolerance.find(cell.place);
    return tolerance == nullptr ? "" : *tolerance;
  }

  void add(Cell before, Cell after) {
    if (before.kind != Cell::Kind::finding && is_apart(before, true)) return;
    if (before.member == "tolerance_failures" && tolerance_of(before_, before) != tolerance_of(after_, after))
      return note_absent(before, true, "was counted with a different tolerance", Absence::fails);
    // A greatest error of no answer is no 0 that may grow.
    if (before.kind == Cell::Kind::maximum && before.looked_at == 0 && after.looked_at != 0)
      return note_absent(after, false, "was looked at on no answer in OLD", Absence::only_new);
    ComparedCell compared{std::move(before), std::move(after)};
    compared.same_queries = !compared.before.precision.empty() &&
                            has_same_queries(compared.before.family, precision_of_name(compared.before.precision));
    const Cell &x = compared.before, &y = compared.after;
    if (x.kind == Cell::Kind::count && !compared.same_queries) {
      const auto [u, v] = independent(x, y);
      compared.p = fisher_two_sided(u, v);
      compared.is_breach = x.is_zero() && !y.is_zero() && is_breach(y);
    } else if (x.kind != Cell::Kind::finding && compared.same_queries && x.figure != y.figure) {
      const bool grew = x.kind == Cell::Kind::count ? x.count() < y.count() : is_less(x.figure, y.figure);
      if (grew || !is_over_others(x)) compared.change = direction(x, y, grew);
    }
    result_.cells.push_back(std::move(compared));
  }

  // Whether other answers have what a figure of OLD is about: nothing is better there.
  bool is_over_others(const Cell& cell) {
    const std::string& kernel = pairs_.of(cell, true).before;
    return std::ranges::any_of(shown_of(cell.place, cell.member), [&](std::string_view shown) {
      return hidden_.contains({kernel, cell.precision, cell.family, std::string(shown)});
    });
  }

  // Answers that no promise of NEW's allows: one is a fault, whatever the queries.
  bool is_breach(const Cell& cell) const {
    if (cell.place != "verdict") return false;
    if (cell.member == "invalid" || cell.member == "unanswered") return true;
    if (cell.member != "undecided") return false;
    const KernelRecord* const entry = precision_entry(after_, cell.kernel, precision_of_name(cell.precision));
    return entry != nullptr && !promise_in(*entry).may_decline;
  }

  void correct() {
    std::vector<double> p;
    for (const ComparedCell& cell : result_.cells) {
      if (cell.p) p.push_back(*cell.p);
    }
    result_.tested = p.size();
    const std::vector<double> corrected = holm(p);
    std::size_t next = 0;
    for (ComparedCell& cell : result_.cells) {
      if (!cell.p) continue;
      cell.p_corrected = corrected[next++];
      if (cell.is_breach) cell.change = Change::fresh;
      if (cell.is_breach || *cell.p_corrected > family_wise_error) continue;
      const auto rate = [](const Cell& of) {
        return static_cast<double>(of.of.failures) / static_cast<double>(of.of.trials);
      };
      const bool grew = rate(cell.before) < rate(cell.after);
      if (grew || !is_over_others(cell.before)) cell.change = direction(cell.before, cell.after, grew);
    }
  }

  // Counts what was compared of each kernel, and names the witnesses of each alarm.
  void name_witnesses() {
    const WitnessesByCell witnesses(after_);
    for (ComparedCell& cell : result_.cells) {
      if (cell.is_compared()) {
        ++pairs_.of(cell.before, true).cells;
        compared_.emplace(cell.before.kernel, cell.before.precision);
      }
      if (!cell.is_alarm()) continue;
      for (const WitnessRecord* witness : witnesses.of(cell.after)) cell.witnesses.push_back(witness->id);
    }
  }

  void note_kernels_without_cells() {
    for (const ComparedKernel& kernel : pairs_.all()) {
      if (!kernel.is_in_both() || is_unloaded(kernel)) continue;
      for (const KernelRecord* then : precision_entries(before_, kernel.before)) {
        const std::string precision(name(then->precision));
        if (compared_.contains({kernel.before, precision})) continue;
        note(fmt::format("{} {}", kernel.before, precision), "has no family with promised queries in both runs",
             kernel);
      }
    }
  }

  const Record &before_, &after_;
  KernelPairs pairs_;
  std::vector<std::string> unloaded_;  // ids in NEW
  RunComparison result_;
  std::set<std::string> said_;                              // each `what` of not_compared, with its kernel
  std::set<std::string> lost_;                              // families of one plan alone
  std::set<std::array<std::string, 4>> hidden_;             // and a number that stands beside other answers
  std::set<FamilyOfKernel> apart_;                          // counted over other promised queries
  std::set<std::pair<std::string, std::string>> compared_;  // OLD's ids, and precisions
};

}  // namespace

std::size_t RunComparison::alarms() const {
  const auto is_alarm = [](const auto& item) { return item.is_alarm(); };
  return static_cast<std::size_t>(std::ranges::count_if(cells, is_alarm) + std::ranges::count_if(promises, is_alarm) +
                                  std::ranges::count_if(replayed, is_alarm));
}

bool RunComparison::has(Absence absence) const {
  return std::ranges::any_of(not_compared, [&](const NotCompared& absent) { return absent.absence == absence; });
}

std::size_t RunComparison::compared() const {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [](const ComparedCell& cell) { return cell.is_compared(); }));
}

std::size_t RunComparison::count(Change change) const {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](const ComparedCell& cell) { return cell.change == change; }));
}

void require_same_predicate(const Record& before, const Record& after, const std::string& before_name,
                            const std::string& after_name) {
  const std::string &old_predicate = before.plan.predicate, &new_predicate = after.plan.predicate;
  if (old_predicate == new_predicate) return;
  throw Error(fmt::format("{} is of the predicate {}, and {} of {}; only runs of one predicate can be compared",
                          before_name, old_predicate, after_name, new_predicate));
}

RunComparison compare_records(const Record& before, const Record& after, std::vector<ReplayedQuery> replayed,
                              const std::vector<std::string>& allowed) {
  require_same_predicate(before, after, "OLD", "NEW");
  return Comparer(before, after).run(std::move(replayed), allowed);
}

}  // namespace axiscert
