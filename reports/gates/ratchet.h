// The ratchet: a reviewed text file of what each kernel promises and of the errors that are accepted. A run may get
// better, never worse; a kernel that promises less is worse.
// `ratchet_text.h` states the format of the file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/record/record.h"
#include "kernel/test.h"
#include "reports/comparison/promise.h"
#include "reports/run_folder/identity.h"

namespace axiscert {

// Until when, by whom and why errors are accepted.
struct Waiver {
  std::string expiry, owner, reason;  // expiry: the last day, YYYY-MM-DD in UTC, or `never`
  bool operator==(const Waiver&) const = default;
};

struct RatchetEntry {
  Json key;  // that of the cell; the kernel by its identity, or by its id
  Json figure;
  Waiver waiver;
  std::size_t line = 0;
};

// The promise of a kernel in one precision, and the number of the plan's queries on which it makes it.
struct HeldPromise {
  std::string kernel, precision;  // the kernel as the keys have it
  Promise promise;
  std::uint64_t queries = 0;
  std::size_t line = 0;
};
const HeldPromise* find_promise(const std::vector<HeldPromise>& all, const std::string& kernel,
                                const std::string& precision);

struct Ratchet {
  std::string name, plan;
  std::string test;  // its id
  std::vector<HeldPromise> promises;
  std::map<std::string, RatchetEntry> entries;  // by fingerprint
  std::map<std::string, Digests> digests;       // of the kernels' files, by the kernel as the keys have it
};

// Throws Error where the plan of a record is of another test than the ratchet, is not the ratchet's, or cannot be
// repeated.
void require_plan(const Ratchet& ratchet, const PlanRecord& plan);

struct RatchetFailure {
  Json key;            // that of the cell, or of all cells of a kernel and precision: family and name are "*"
  std::string kernel;  // its id in the record, or its name in the ratchet where the record does not have it
  std::string text;    // one line: names the cell, says what is wrong, and where it is accepted
};
struct RatchetOutcome {
  std::vector<RatchetFailure> failures;  // promises less, worse, expired, not compared or checked; the worst first
  std::vector<std::string> better;       // a line each
  std::vector<std::string> changed;      // kernels whose files are others than those that the ratchet was written for
  // The cells that are as bad as accepted, or less, by waiver: their fingerprints.
  std::vector<std::pair<Waiver, std::vector<std::string>>> held;
  std::string accepted;  // the file that would accept the record; EXPIRY, OWNER and REASON are left to fill in where it
                         // is worse
};
// Compares a record with the ratchet; `today` is YYYY-MM-DD. Throws Error as require_plan does.
RatchetOutcome hold_against(const Ratchet& ratchet, const Record& record, const std::string& today);

// The outcome for the reports of a run, `ratchet_outcome_file` in its folder: conforms to ratchet.schema.json.
Json outcome_json(const Ratchet& ratchet, const RatchetOutcome& outcome);

// The file that accepts the record as it is, with EXPIRY, OWNER and REASON left to fill in; only a comment where the
// record depended on time.
std::string ratchet_text(const Record& record);

}  // namespace axiscert
