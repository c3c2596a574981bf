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
#include "kernel/predicate.h"
#include "reports/comparison/promise.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/ratchet_outcome.h"

namespace axiscert {

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
  std::string predicate;  // its id
  std::vector<HeldPromise> promises;
  std::map<std::string, RatchetEntry> entries;  // by fingerprint
  std::map<std::string, Digests> digests;       // of the kernels' files, by the kernel as the keys have it
};

// Throws Error where the plan of a record is of another predicate than the ratchet, is not the ratchet's, or cannot be
// repeated.
void require_plan(const Ratchet& ratchet, const PlanRecord& plan);

// Compares a record with the ratchet; `today` is YYYY-MM-DD. The outcome is for the reports of the run,
// `ratchet_outcome_file` in its folder. Throws Error as require_plan does.
RatchetOutcome hold_against(const Ratchet& ratchet, const Record& record, const std::string& today);

// The file that accepts the record as it is, with EXPIRY, OWNER and REASON left to fill in; only a comment where the
// record depended on time.
std::string ratchet_text(const Record& record);

}  // namespace axiscert
