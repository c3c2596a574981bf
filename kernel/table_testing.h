// The expected answers of every registered kernel to hand-worked queries: the rows of the table "What each answers" of
// docs/kernels.md, to which the tests hold the kernels.
#pragma once

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/base/enums.h"

namespace axiscert::testing_support {

enum class Says {
  right,      // the truth, every time
  wrong,      // not the truth in some case
  contact,    // in every case
  separated,  // in every case
  invalid,    // in every case
  undecided,  // in every case
  declines,   // the truth or undecided
  varies,     // with the query or the order of its vertices
};
inline constexpr EnumArray<Says, std::string_view, 8> says_names = {"right",   "wrong",     "contact",  "separated",
                                                                    "invalid", "undecided", "declines", "varies"};

// From `repeated` to `infinite_centre` the sphere is clear of the triangle, or was so before a coordinate was replaced.
struct Behaviour {
  Says area;             // a triangle with area: clear of each feature, overlapping, touching
  Says repeated;         // two vertices equal, the sphere clear of the segment
  Says collinear;        // three vertices on a line, the foot of the centre between them
  Says point;            // all three equal
  Says nan;              // one coordinate of one vertex is NaN
  Says infinite;         // one coordinate of one vertex is infinite
  Says infinite_centre;  // one coordinate of the centre is infinite
  Says negative_radius;  // radius -1, for a sphere that overlaps an edge or the face at radius 1
};
struct BehaviourRow {
  std::string kernel;
  Behaviour behaviour;
};

inline std::string row_text(std::string_view kernel, const Behaviour& b) {
  std::string row = "| `" + std::string(kernel) + "` |";
  for (const Says cell :
       {b.area, b.repeated, b.collinear, b.point, b.nan, b.infinite, b.infinite_centre, b.negative_radius}) {
    row += " " + std::string(says_names[cell]) + " |";
  }
  return row;
}

inline constexpr std::string_view behaviours_place = "docs/kernels.md, table \"What each answers\"";

// The figures of each kernel that the first cell names. Throws std::runtime_error with the row that has not nine cells,
// or whose answers are not among `says_names`.
inline std::vector<BehaviourRow> parsed_row(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t at = 1; at < row.size();) {
    const std::size_t end = std::min(row.find('|', at), row.size());
    const std::size_t first = row.find_first_not_of(" `", at), last = row.find_last_not_of(" `", end - 1);
    cells.push_back(first < end ? row.substr(first, last + 1 - first) : "");
    at = end + 1;
  }
  const auto wrong = [&](const std::string& what) {
    return std::runtime_error(std::string(behaviours_place) + ": " + what + " in the row\n" + row);
  };
  if (cells.size() != 9) throw wrong(std::to_string(cells.size()) + " cells where there should be 9");
  const auto says = [&](std::size_t i) {
    const auto found = std::find(says_names.begin(), says_names.end(), cells[i]);
    if (found == says_names.end())
      throw wrong("'" + cells[i] + "', which is no answer that kernel/table_testing.h knows,");
    return static_cast<Says>(found - says_names.begin());
  };
  const Behaviour behaviour{says(1), says(2), says(3), says(4), says(5), says(6), says(7), says(8)};
  std::vector<BehaviourRow> rows;
  constexpr std::string_view between = "`, `";
  for (std::size_t at = 0; at < cells[0].size();) {
    const std::size_t end = std::min(cells[0].find(between, at), cells[0].size());
    rows.push_back({cells[0].substr(at, end - at), behaviour});
    at = end + between.size();
  }
  return rows;
}

inline const std::vector<BehaviourRow>& behaviours() {
  static const std::vector<BehaviourRow> rows = [] {
    std::ifstream file(SOURCE_FOLDER "/docs/kernels.md");
    std::vector<BehaviourRow> found;
    bool in_table = false;
    for (std::string line; std::getline(file, line);) {
      if (line.starts_with("| kernel | area |")) in_table = true;
      else if (!line.starts_with("|")) in_table = false;
      else if (in_table && line.starts_with("| `")) {
        for (BehaviourRow& row : parsed_row(line)) found.push_back(std::move(row));
      }
    }
    if (found.empty()) throw std::runtime_error(std::string(behaviours_place) + ": not found, or without a row");
    return found;
  }();
  return rows;
}

}  // namespace axiscert::testing_support
