#include "proofs/emit/emit.h"

#include <fmt/format.h>

namespace axiscert::proofs {

std::string program_path(std::string_view name) { return fmt::format("programs/{}.txt", name); }

Files proof_files() {
  Files all;
  all.merge(coq_files());
  all.merge(gappa_files());
  all.merge(range_files());
  all.merge(header_files());
  all.merge(fpcore_files());
  all.merge(latex_files());
  all.merge(certified_files());
  return all;
}

}  // namespace axiscert::proofs
