// The files made from the recorded formulae, one or more for each language, committed beside the proofs.
#pragma once

#include <map>
#include <string>

#include "proofs/certified/graph.h"

namespace axiscert::proofs {

// Texts by path under proofs/.
using Files = std::map<std::string, std::string>;

Files coq_files();
Files gappa_files();
Files range_files();
Files fpcore_files();
Files latex_files();
// kernel/sphere_triangle/proved_bounds.h, by its path relative to proofs/.
Files header_files();

// The steps of the certified predicate, proofs/certified.
Files certified_files();
// A step as steps_plain.txt and steps_fma.txt have it.
std::string text_of(const certified::RecordedStep& step);

// All of these files.
Files proof_files();

}  // namespace axiscert::proofs
