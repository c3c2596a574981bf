// What the recorder is for: one file a language, made from the formulae and committed beside the proofs.
#pragma once

#include <map>
#include <string>

namespace axiscert::proofs {

// By path under exact/proofs/.
using Files = std::map<std::string, std::string>;

Files coq_files();
Files gappa_files();
Files range_files();
Files fpcore_files();
Files latex_files();
// kernel/proved_bounds.h, its path seen from exact/proofs/.
Files header_files();

// All of them.
Files proof_files();

}  // namespace axiscert::proofs
