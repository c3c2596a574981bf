// The ratchet: a reviewed text file, whose format stands below, of what each kernel promises and of the errors that are
// accepted. A run may get better, never worse; a kernel that promises less is worse.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/record/record.h"
#include "fuzz/text/json.h"
#include "kernel/predicate.h"
#include "reports/comparison/promise.h"
#include "reports/comparison/shown.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
struct RatchetEntry {
  Json key;  // that of the cell; the kernel by its identity, or by its id
  Json figure;
  Waiver waiver;
  std::size_t line = 0;
};

// The promise of a kernel in one precision, what it shows beside its verdicts, and the number of the plan's queries on
// which it makes it.
struct HeldPromise {
  std::string kernel, precision;  // the kernel as the keys have it
  Promise promise;
  std::vector<Shown> shows;
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

// The file of a ratchet:
//
//   axiscert-ratchet/5 PLAN [PREDICATE]
//   kernel: KERNEL [FILE:SHA256]...
//   promise: PRECISION queries=NUMBER touching=ANSWER [PART]... [shows=NAME,...] [MEASURE=COUNT@MARK,COUNT@MARK]...
//   accept: EXPIRY OWNER REASON
//   kernel: KERNEL
//   family: PRECISION FAMILY
//   PLACE FIGURE=NUMBER [FIGURE=NUMBER]...
//
// PLAN is plan_fingerprint(): figures over other queries are not compared. PREDICATE is the predicate of the run;
// sphere-triangle is not written. Each line that ends its first word with a colon is about all lines below it, up to
// the next of its kind; `kernel:` also ends the family. KERNEL is the identity of a kernel, with the digests of its
// files where it has any: they tell of a change and are not required to be the same. `promise:` is what the kernel
// promises in a precision, in the words of words_of_promise(), and on how many of the plan's queries; what
// it shows beside its verdicts stands in the words of words_of_shown(). Every kernel of the run has one for each
// precision in which it exists, whether or not it is wrong anywhere, and no figure stands without it. `loading:` stands
// for the family of findings that were made in loading. PLACE and FIGURE are the two parts of the name of a cell of
// cells_of(), NUMBER is its count, or its depth where it is a maximum; a cell that is not there is accepted at zero.
// Counts, findings and depths are checked; errors in u are not, since --tolerance makes a count of them. A word that
// contains spaces or quotes is a JSON string. Empty lines and lines that begin with # are comments.

// Throws Error that names file, line and word, and says what would be right.
Ratchet parse_ratchet(std::string_view text, const std::string& name);
Ratchet read_ratchet(const std::string& path);

// A waiver that is left to fill in: a file that has it is refused.
const Waiver& open_waiver();

// The file: promises first; what is alike in `entries` is written once, in the order in which it first appears, and
// what is open comes last. `line` is not read.
std::string ratchet_file(const std::string& plan, const Predicate& predicate, const std::vector<HeldPromise>& promises,
                         const std::vector<RatchetEntry>& entries, const std::map<std::string, Digests>& digests);

}  // namespace axiscert
