// The programs that check proofs, run on the committed and the generated files.
#pragma once

#include <optional>
#include <string>

namespace axiscert::proofs {

// "Gappa 1.4.1", the first line that the program says of itself; nothing where it is not installed.
std::optional<std::string> gappa_version();
std::optional<std::string> coq_version();

// Whether Gappa proves the script.
bool gappa_accepts(const std::string& script);
// Whether Coq accepts Ranges.v and RangesClaimed.v of the folder, whose text must be `claimed`. Throws Error where a
// file cannot be read.
bool coq_accepts_ranges(const std::string& folder, const std::string& claimed);

}  // namespace axiscert::proofs
