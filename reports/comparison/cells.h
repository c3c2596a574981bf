// The cells of a record: every count of something wrong, by kernel, precision, family and where it shows. What
// `compare` and the ratchet hold against each other, and what CI formats name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/comparison/two_proportions.h"
#include "fuzz/text/json.h"

namespace axiscert {

struct Cell {
  enum class Kind {
    count,    // of queries
    maximum,  // over queries: comparable on the same queries only
    finding   // how often a plug-in did what it must not: wrong from the first
  };
  std::string kernel, precision, family;  // of a finding in loading, the last two are empty
  std::string place;                      // "verdict", a comparison, or "finding"
  std::string member;                     // as in the record; of a finding its kind
  Kind kind = Kind::count;
  Json figure = 0;                // a count; a maximum may be the text of a number that binary64 cannot hold
  Proportion of;                  // of a count: among how many queries it was counted
  std::uint64_t independent = 0;  // of these queries, how many do not share a triangle

  std::string name() const { return place + "." + member; }
  std::uint64_t count() const { return figure.get<std::uint64_t>(); }
  bool is_zero() const { return figure == 0; }
  // kernel, precision, family, name: what two records have in common.
  Json key() const { return Json::array({kernel, precision, family, name()}); }
};

// In the record's order, those of a figure zero among them. `record` is one that read_run accepted.
std::vector<Cell> cells_of(const Json& record);

// 16 hex digits of the SHA-256 of a cell's key: the same in every run that has the cell, whatever its figure.
std::string fingerprint(const Json& key);

// What decides which queries a family's cell was counted over: seed or file, generator, trials. Null where it depended
// on time. Equal texts are equal queries.
Json queries_of(const Json& plan, const std::string& family, const std::string& precision);
// 16 hex digits over all families and tolerances of a plan, kernels apart. Empty where it depended on time.
std::string plan_fingerprint(const Json& plan);

// The witnesses of the record that show the cell.
std::vector<const Json*> witnesses_of(const Json& record, const Cell& cell);

}  // namespace axiscert
