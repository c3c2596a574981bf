// What the recorder is for: one file a language, made from the formulae and committed beside the proofs.
#pragma once

#include <map>
#include <string>

namespace axiscert::proofs {

// By path under proofs/.
using Files = std::map<std::string, std::string>;

Files coq_files();
Files gappa_files();
Files range_files();
Files fpcore_files();
Files latex_files();
// kernel/sphere_triangle/proved_bounds.h, its path seen from proofs/.
Files header_files();

// All of them.
Files proof_files();

}  // namespace axiscert::proofs
