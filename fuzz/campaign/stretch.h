// A stretch: consecutive units of one source and precision, the smallest portion that is handed out, journalled and
// repeated. Its result depends on the plan and its number alone, to the byte.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"

namespace axiscert {
// Tallies as bytes (CBOR), for the journal and between ranks: equal tallies have equal bytes, in whatever order they
// were merged.

// The cost of a stretch: all of it goes to run.json, none of it to a record. It depends on the machine.
struct Costs {
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;

  AXISCERT_FIELDS(Costs, journalled(&Costs::core_seconds, by::added), journalled(&Costs::second_opinions),
                  journalled(&Costs::steps))
};

std::string encode(const Tally& tally);
std::string encode(const Costs& costs);
// Both throw Error for bytes that encode() does not produce; a tally is of a predicate.
Tally decode_tally(std::string_view bytes, const Predicate& predicate);
Costs decode_costs(std::string_view bytes);

// A cell of a plan: a source in a precision, by the numbers that its stretches follow from.
struct PlannedCell {
  std::size_t source;  // index in the plan's sources
  Precision precision;
  std::uint64_t queries;
  std::string family;  // the source's name
};
// Those of the questions, in the order of cells_of().
std::vector<PlannedCell> planned_cells(const Questions& questions);

struct Stretch {
  std::size_t cell, source;  // index in cells_of(), and in the plan's sources
  Precision precision;
  std::uint64_t first_unit;  // within the cell
  std::uint64_t queries;     // from the first query of that unit on
  std::uint64_t units() const { return (queries + unit_size - 1) / unit_size; }
};

// The stretches of a plan, in the order in which they are handed out: one of each cell in turn, so that every part of
// the order contains a share of each cell. Nothing is stored per stretch.
class Stretches {
 public:
  // Throws Error if there are more than a journal supports: the remedy is a greater `units_each`.
  Stretches(const Questions& questions, std::uint64_t units_each) : Stretches(planned_cells(questions), units_each) {}
  Stretches(std::vector<PlannedCell> cells, std::uint64_t units_each);
  std::uint64_t count() const { return count_; }
  std::uint64_t units() const { return units_; }
  std::uint64_t queries() const { return queries_; }
  std::uint64_t units_each() const { return units_each_; }
  Stretch at(std::uint64_t number) const;
  // "tangent binary32, unit 7" or "... units 4 to 7".
  std::string text(std::uint64_t number) const;
  // The units of many stretches, cell by cell: "tangent binary32: units 0 to 3, 7". At most `limit` parts, followed by
  // how many more there are.
  std::string text(const std::vector<std::uint64_t>& numbers, std::size_t limit) const;

  // The greatest number of stretches that a journal supports, some gigabytes, however many queries there are.
  static constexpr std::uint64_t most = std::uint64_t{1} << 22;
  // A stretch of 16 units takes a fraction of a second, compared with which the cost of its entry (scale_bench) and of
  // beginning it is negligible; but a plan has 1024 stretches before any has more than one unit, so that no thread
  // waits long for the last of them.
  static constexpr std::uint64_t usual_units = 16, enough_stretches = 1024;
  static std::uint64_t default_units_each(const Questions& questions) {
    return default_units_each(planned_cells(questions));
  }
  static std::uint64_t default_units_each(const std::vector<PlannedCell>& cells);

 private:
  // Stretches during which the cells with the fewest stretches are not finished: `cells` take turns.
  struct Level {
    std::uint64_t first_number, first_index;
    std::vector<std::size_t> cells;
  };

  std::string cell_text(std::size_t cell) const;

  std::vector<PlannedCell> cells_;
  std::uint64_t units_each_, count_ = 0, units_ = 0, queries_ = 0;
  std::vector<Level> levels_;
};

// The cells with all of their queries, and without tallies: the part of a result that the questions determine.
CampaignResult planned(const Questions& questions);

// A finished stretch, as stored in the journal and exchanged between ranks.
struct Entry {
  std::uint64_t stretch;
  std::vector<std::string> tallies;  // encoded, per kernel
  std::string costs;                 // encoded
};
std::string encode(const Entry& entry);
Entry decode_entry(std::string_view bytes);  // throws Error

Entry run_stretch(const Plan& plan, const Stretches& stretches, std::uint64_t number);

}  // namespace axiscert
