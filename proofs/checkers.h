// The programs that check proofs, run on the committed and the generated files.
#pragma once

#include <optional>
#include <string>

namespace axiscert::proofs {

// The first line that the program prints about its version, such as "Gappa 1.4.1"; empty if it is not installed.
std::optional<std::string> gappa_version();
std::optional<std::string> coq_version();

// Whether Gappa proves the script.
bool gappa_accepts(const std::string& script);
// Whether Coq accepts the folder's coq/formulae/Ranges.v together with `claimed` as RangesClaimed.v. Throws Error if a
// file cannot be read.
bool coq_accepts_ranges(const std::string& folder, const std::string& claimed);

}  // namespace axiscert::proofs
