// Two records held against each other, cell by cell.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/comparison/cells.h"
#include "reports/comparison/replay.h"

namespace axiscert {

// The probability, at most, that two runs that differ in nothing but chance give any alarm at all.
inline constexpr double family_wise_error = 0.05;

// fresh: none in OLD, some in NEW; fixed: some in OLD, none in NEW. Of cells counted over different queries all but
// `unchanged` are said only where chance is no explanation.
enum class Change { fresh, worse, better, fixed, unchanged };
inline constexpr std::array<std::string_view, 5> change_names = {"new", "worse", "better", "fixed", "unchanged"};
constexpr std::string_view name(Change change) { return change_names[static_cast<std::size_t>(change)]; }

struct ComparedCell {
  Cell before, after;
  Change change = Change::unchanged;
  bool same_queries = false;                 // then figures are compared as they are
  std::optional<double> p{}, p_corrected{};  // of different queries: Fisher's, and after Holm's correction
  std::vector<std::string> witnesses{};      // ids in NEW, where it is new or worse

  bool is_alarm() const { return change == Change::fresh || change == Change::worse; }
};

// What only one of the two has, or what they counted in different ways.
struct NotCompared {
  std::string what, why;
};

struct RunComparison {
  std::vector<ComparedCell> cells;  // in OLD's order, then what only findings of NEW have
  std::vector<NotCompared> not_compared;
  std::size_t tested = 0;          // cells that Holm's correction is over
  std::vector<Replayed> replayed;  // OLD's witnesses
  std::size_t alarms() const;      // cells that are new or worse, and witnesses that were right and now are wrong
  std::size_t count(Change change) const;
};

// Of two records that read_run accepted; `replayed` is of OLD's witnesses, and may be empty.
RunComparison compare_records(const Json& before, const Json& after, std::vector<Replayed> replayed);

}  // namespace axiscert
