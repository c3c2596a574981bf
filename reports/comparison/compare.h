// Comparison of two records, cell by cell.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/comparison/cells.h"
#include "reports/comparison/not_compared.h"
#include "reports/comparison/promise.h"
#include "reports/comparison/replay.h"

namespace axiscert {

// Upper bound on the probability that two runs that differ by chance alone raise any alarm.
inline constexpr double family_wise_error = 0.05;

// fresh: none in OLD, some in NEW; fixed: some in OLD, none in NEW. For cells counted over different queries, a change
// other than `unchanged` is reported only where chance does not explain it.
enum class Change { fresh, worse, better, fixed, unchanged };
template <>
inline constexpr std::size_t enum_count<Change> = 5;
inline constexpr EnumArray<Change, std::string_view> change_names = {"new", "worse", "better", "fixed", "unchanged"};
constexpr std::string_view name(Change change) { return change_names[change]; }

struct ComparedCell {
  Cell before, after;
  Change change = Change::unchanged;
  bool same_queries = false;                 // then figures are compared as they are
  bool is_breach = false;                    // new, and a fault from the first on: no chance explains it
  std::optional<double> p{}, p_corrected{};  // for different queries: Fisher's, and the same after Holm's correction
  std::vector<std::string> witnesses{};      // ids in NEW, where the cell is new or worse

  bool is_alarm() const { return change == Change::fresh || change == Change::worse; }
  // Whether it holds counts over queries of both runs that can be set against each other.
  bool is_compared() const {
    return before.kind == Cell::Kind::count && before.of.trials != 0 && after.of.trials != 0 && (same_queries || p);
  }
  // No zero that stands for nothing: a kernel that decides no contact misses none, and was not looked at.
  bool is_zero_in_both() const { return before.is_zero() && after.is_zero(); }
  bool is_looked_at() const { return before.looked_at != 0 && after.looked_at != 0; }
  // The id of the kernel, or its identity where the two runs have it under different ids.
  const std::string& kernel() const { return before.kernel == after.kernel ? before.kernel : after.identity; }
};

// A kernel of either plan, or of both.
struct ComparedKernel {
  std::string name;                     // its identity
  std::string before = {}, after = {};  // its ids; empty in a record that does not have it
  std::string digest_change = {};       // which files were changed; empty: none, or not known
  bool has_digests = false;             // whether both records have its digest
  std::size_t cells = 0;                // those of it that are compared

  bool is_in_both() const { return !before.empty() && !after.empty(); }
  std::vector<std::string> names() const { return {name, before, after}; }
  std::optional<std::string> old_id() const { return before.empty() ? std::nullopt : std::optional(before); }
  std::optional<std::string> new_id() const { return after.empty() ? std::nullopt : std::optional(after); }
  std::optional<bool> is_changed() const { return has_digests ? std::optional(!digest_change.empty()) : std::nullopt; }
  AXISCERT_FIELDS(
      ComparedKernel,
      AXISCERT_FIELD(name,
                     "What both runs know it by: plugin/NAME for a plug-in that declares NAME, otherwise its id."),
      journalled(&Of::before), field(&Of::old_id, {"old", "Its id in OLD; null where OLD does not have it."}),
      journalled(&Of::after), field(&Of::new_id, {"new", "Its id in NEW; null where NEW does not have it."}),
      journalled(&Of::digest_change), journalled(&Of::has_digests),
      field(&Of::cells, {"compared", "Counts of it that were compared.", "cells"}),
      field(&Of::is_changed,
            {"changed", "Whether its files have other bytes; null where a record has no digest of them."}))
};

struct RunComparison {
  std::vector<ComparedCell> cells;  // in OLD's order, then the cells that only findings of NEW have
  std::vector<NotCompared> not_compared;
  std::vector<std::string> allowed;  // by which names some of it is allowed
  std::vector<ComparedPromise> promises;
  std::size_t tested = 0;               // number of cells that Holm's correction covers
  std::size_t families = 0;             // of OLD's plan
  std::vector<ComparedKernel> kernels;  // OLD's, then those that only NEW has
  std::vector<ReplayedQuery> replayed;  // OLD's witnesses

  // Cells that are new or worse, promises of less, witnesses that were right and are wrong now or no longer promised.
  std::size_t alarms() const;
  std::size_t count(Change change) const;
  std::size_t compared() const;  // number of cells over queries of both runs
  bool has(Absence absence) const;
  bool passes() const { return alarms() == 0 && compared() != 0 && !has(Absence::fails); }
};

// Throws Error where two records are of different predicates; `before_name` and `after_name` are those that it shows.
void require_same_predicate(const Record& before, const Record& after, const std::string& before_name,
                            const std::string& after_name);

// Compares two records of one predicate that read_run accepted; `replayed` holds OLD's witnesses and may be empty,
// `allowed` what is allowed not to be compared. Throws Error as require_same_predicate and allow do.
RunComparison compare_records(const Record& before, const Record& after, std::vector<ReplayedQuery> replayed,
                              const std::vector<std::string>& allowed = {});

}  // namespace axiscert
