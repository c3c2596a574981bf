// The ratchet: a reviewed text file of the errors that are accepted, one line for each cell. A run may get better,
// never worse.
//
//   axiscert-ratchet/1 PLAN [TEST]
//   FINGERPRINT KERNEL PRECISION FAMILY CELL FIGURE EXPIRY OWNER REASON
//
// PLAN is plan_fingerprint(): figures over other queries are not compared. TEST is the test of the run; sphere-triangle
// is not written. A word that contains spaces or quotes is a
// JSON string. CELL is a name of cells_of(), FIGURE its count, or its depth where it is a maximum; a cell without a
// line is accepted at zero. Counts, findings and depths are checked; errors in u are not, since --tolerance makes a
// count of them. EXPIRY is the last day of the waiver, YYYY-MM-DD in UTC, or `never`. Empty lines and lines that begin
// with # are comments.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/json.h"
#include "kernel/test.h"

namespace axiscert {

struct RatchetEntry {
  Json key;  // that of the cell
  Json figure;
  std::string expiry, owner, reason;
  std::size_t line = 0;
};

struct Ratchet {
  std::string name, plan;
  std::string test = std::string(first_test().id);
  std::map<std::string, RatchetEntry> entries;  // by fingerprint
};

// Throws Error that names file, line and field, and says what would be right.
Ratchet parse_ratchet(std::string_view text, const std::string& name);
Ratchet read_ratchet(const std::string& path);

// Throws Error where a record's `plan` is of another test than the ratchet, is not the ratchet's, or cannot be
// repeated.
void require_plan(const Ratchet& ratchet, const Json& plan);

struct RatchetFailure {
  Json key;          // that of the cell
  std::string text;  // names the cell, says what is wrong, and gives the line that would accept it
};
struct RatchetOutcome {
  std::vector<RatchetFailure> failures;  // worse, expired, or not checked
  std::vector<std::string> better;       // each with the line that replaces the old one
  std::string accepted;  // the file that would accept the record; EXPIRY, OWNER and REASON are left to fill in where it
                         // is worse
};
// Compares a record with the ratchet; `today` is YYYY-MM-DD. Throws Error as require_plan does.
RatchetOutcome hold_against(const Ratchet& ratchet, const Json& record, const std::string& today);

// The outcome for the reports of a run, `ratchet_outcome_file` in its folder: conforms to ratchet.schema.json.
Json outcome_json(const Ratchet& ratchet, const RatchetOutcome& outcome);

// The file that accepts the record as it is, with EXPIRY, OWNER and REASON left to fill in; only a comment where the
// record depended on time.
std::string ratchet_text(const Json& record);

}  // namespace axiscert
