// The files made from the recorded formulae and steps, one or more for each language.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "proofs/certified/graph.h"

namespace axiscert::proofs {

// Texts by path: coq/, which completes the theory in proofs/coq; ranges/, which Coq checks beside it; gappa/, fpcore/,
// latex/; programs/, of which programs.txt has the digests; and kernel/, whose header is committed.
using Files = std::map<std::string, std::string>;

Files coq_files();
Files gappa_files();
Files range_files();
Files fpcore_files();
Files latex_files();
// kernel/sphere_triangle/proved_bounds.h.
Files header_files();

// The steps of the certified predicate.
Files certified_files();
// A step as a program: an operation a line.
std::string text_of(const certified::RecordedStep& step);
// The path of a program: a step, or a set of formulae.
std::string program_path(std::string_view name);

// All of these files.
Files proof_files();

}  // namespace axiscert::proofs
