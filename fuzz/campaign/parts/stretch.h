// A stretch: consecutive units of one source and precision, the least that is handed out, journalled and done again.
// Its result depends on the plan and its number alone, to the byte.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign/parts/tally_code.h"

namespace axiscert {

struct Stretch {
  std::size_t cell, source;  // of cells_of(plan) and of the plan
  Precision precision;
  std::uint64_t first_unit;  // of the cell
  std::uint64_t queries;     // from that unit's first one on
  std::uint64_t units() const { return (queries + unit_size - 1) / unit_size; }
};

// The stretches of a plan, in the order in which they are handed out: one of each cell in turn, so that every part of
// the order has its share of each. Nothing is stored by stretch.
class Stretches {
 public:
  // Throws Error where there are more than a journal is made for: a greater `units_each` is right.
  Stretches(const Plan& plan, std::uint64_t units_each);
  std::uint64_t count() const { return count_; }
  std::uint64_t units() const { return units_; }
  std::uint64_t queries() const { return queries_; }
  std::uint64_t units_each() const { return units_each_; }
  Stretch at(std::uint64_t number) const;
  // "tangent binary32, unit 7" or "... units 4 to 7".
  std::string text(std::uint64_t number) const;
  // The units of many stretches, cell by cell: "tangent binary32: units 0 to 3, 7". At most `limit` parts, then how
  // many more.
  std::string text(const std::vector<std::uint64_t>& numbers, std::size_t limit) const;

  // The most that a journal is made for, some gigabytes, however many queries there are.
  static constexpr std::uint64_t most = std::uint64_t{1} << 22;
  // A stretch of 16 units takes a fraction of a second, beside which its entry (scale_bench) and that it is begun anew
  // count nothing; but a plan has 1024 stretches before one has more than a unit, so that no thread waits long for the
  // last of them.
  static constexpr std::uint64_t usual_units = 16, enough_stretches = 1024;
  static std::uint64_t default_units_each(const Plan& plan);

 private:
  // While the cells that have the fewest stretches are not through: `cells` take turns.
  struct Level {
    std::uint64_t first_number, first_index;
    std::vector<std::size_t> cells;
  };

  struct Cell {
    std::size_t source;
    Precision precision;
    std::uint64_t queries;
    std::string name;
  };

  std::vector<Cell> cells_;
  std::uint64_t units_each_, count_ = 0, units_ = 0, queries_ = 0;
  std::vector<Level> levels_;
};

// The cells of a plan with all of its queries in them: its result, as far as the plan tells it.
CampaignResult planned(const Plan& plan);

// A finished stretch, as the journal and the ranks hold it.
struct Entry {
  std::uint64_t stretch;
  std::vector<std::string> tallies;  // encoded, by kernel
  std::string costs;                 // encoded
};
std::string encode(const Entry& entry);
Entry decode_entry(std::string_view bytes);  // throws Error

Entry run_stretch(const Plan& plan, const Stretches& stretches, std::uint64_t number);

}  // namespace axiscert
