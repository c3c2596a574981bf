// The cells of a record: one figure for each kernel, precision, family and place where something can be wrong.
// `compare` and the ratchet compare cells, and the formats for CI name them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/proportions.h"
#include "fuzz/record/record.h"
#include "fuzz/text/json.h"

namespace axiscert {

// The places of what a kernel says beside its verdicts, those of the record's `contacts`: of motions "missed" too, for
// the contacts that it did not find.
bool is_place_of_contacts(std::string_view place);
// Those that a predicate has.
std::vector<std::string_view> places_of_contacts(const Predicate& predicate);

struct Cell {
  enum class Kind {
    count,    // a number of queries
    maximum,  // a maximum over queries: comparable on the same queries only
    finding   // how often a plug-in broke a rule: wrong from the first time on
  };
  std::string kernel, precision, family;  // for a finding made in loading, the last two are empty
  std::string place;                      // "verdict", a comparison, "finding", or one of contacts
  std::string member;                     // the name in the record; for a finding, its kind
  Kind kind = Kind::count;
  Json figure = 0;                // as the record has it: a maximum may be the text of a number beyond binary64
  Proportion of;                  // for a count: the number of queries among which it was counted
  std::uint64_t independent = 0;  // how many of these queries do not share a triangle
  std::uint64_t looked_at = 0;    // the answers that could have made it more: of missed contacts, decided contacts
  std::string identity = {};      // what other runs know the kernel by; `kernel` is its id in this record

  bool is_of_contacts() const { return is_place_of_contacts(place); }
  std::string name() const { return place + "." + member; }
  std::uint64_t count() const { return figure.get<std::uint64_t>(); }
  bool is_zero() const { return figure == 0; }
  // The kernel's identity, precision, family and name: they identify the cell in two records.
  Json key() const { return key_of(identity); }
  // The same with another text for the kernel.
  Json key_of(const std::string& known_by) const { return Json::array({known_by, precision, family, name()}); }
};

// The figures of a place, but for errors in u: of "verdict", of "finding", of a place of contacts, or of any
// comparison.
std::vector<std::string_view> members_of(std::string_view place);
// Whether a cell is the largest error in u: compared on the same queries, and not held by a ratchet.
bool is_error_in_u(const Cell& cell);

// The cells in the record's order, including those with the figure zero.
std::vector<Cell> cells_of(const Record& record);

// The counts of both cells as independent trials: queries that share a triangle count as one, and the count of failures
// is scaled down with them. A remaining fraction is rounded towards the other cell's rate, which never causes an alarm.
std::pair<Proportion, Proportion> independent(const Cell& x, const Cell& y);

// The first 16 hex digits of the SHA-256 of a cell's key: the same in every run that has the cell, whatever its figure.
std::string fingerprint(const Json& key);
// "published binary32 on tangent: verdict.false_separation": the cell with this key.
std::string cell_text(const Json& key);

// The witnesses of a record, which has to outlive this, by the cells that they show: a large run has thousands of each.
class WitnessesByCell {
 public:
  explicit WitnessesByCell(const Record& record);
  // Those that show the cell, in the record's order.
  std::vector<const WitnessRecord*> of(const Cell& cell) const;

 private:
  using Place = std::array<std::string, 3>;  // kernel, precision, family
  std::map<Place, std::vector<const WitnessRecord*>> by_place_;
};

}  // namespace axiscert
