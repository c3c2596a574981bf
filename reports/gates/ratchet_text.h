// The file of a ratchet:
//
//   axiscert-ratchet/3 PLAN [PREDICATE]
//   kernel: KERNEL [FILE:SHA256]...
//   promise: PRECISION queries=NUMBER touching=ANSWER [PART]...
//   accept: EXPIRY OWNER REASON
//   kernel: KERNEL
//   family: PRECISION FAMILY
//   PLACE FIGURE=NUMBER [FIGURE=NUMBER]...
//
// PLAN is plan_fingerprint(): figures over other queries are not compared. PREDICATE is the predicate of the run;
// sphere-triangle is not written. Each line that ends its first word with a colon is about all lines below it, up to
// the next of its kind; `kernel:` also ends the family. KERNEL is the identity of a kernel, with the digests of its
// files where it has any: they tell of a change and are not required to be the same. `promise:` is what the kernel
// promises in a precision, in the words of words_of_promise(), and on how many of the plan's queries: every kernel of
// the run has one for each precision in which it exists, whether or not it is wrong anywhere, and no figure stands
// without it. `loading:` stands for the family of findings that were made in loading. PLACE and FIGURE are the two
// parts of the name of a cell of cells_of(), NUMBER is its count, or its depth where it is a maximum; a cell that is
// not there is accepted at zero. Counts, findings and depths are checked; errors in u are not, since --tolerance makes
// a count of them. A word that contains spaces or quotes is a JSON string. Empty lines and lines that begin with # are
// comments.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reports/gates/ratchet.h"

namespace axiscert {

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
