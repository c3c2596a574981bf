// Comparison of two records, cell by cell.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/comparison/cells.h"
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
  std::optional<double> p{}, p_corrected{};  // for different queries: Fisher's, and the same after Holm's correction
  std::vector<std::string> witnesses{};      // ids in NEW, where the cell is new or worse

  bool is_alarm() const { return change == Change::fresh || change == Change::worse; }
};

// Something that only one of the two records has, or that they counted in different ways.
struct NotCompared {
  std::string what, why;
};

struct RunComparison {
  std::vector<ComparedCell> cells;  // in OLD's order, then the cells that only findings of NEW have
  std::vector<NotCompared> not_compared;
  std::size_t tested = 0;          // number of cells that Holm's correction covers
  std::vector<Replayed> replayed;  // OLD's witnesses
  std::size_t alarms() const;      // cells that are new or worse, and witnesses that were right and are now wrong
  std::size_t count(Change change) const;
};

// The counts of both cells as independent trials: queries that share a triangle count as one, and the count of failures
// is scaled down with them. A remaining fraction is rounded towards the other cell's rate, which never causes an alarm.
std::pair<Proportion, Proportion> independent(const Cell& x, const Cell& y);

// Throws Error where two records are of different tests; `before_name` and `after_name` are those that it shows.
void require_same_test(const Json& before, const Json& after, const std::string& before_name,
                       const std::string& after_name);

// Compares two records of one test that read_run accepted; `replayed` holds OLD's witnesses and may be empty. Throws
// Error as require_same_test does.
RunComparison compare_records(const Json& before, const Json& after, std::vector<Replayed> replayed);

}  // namespace axiscert
