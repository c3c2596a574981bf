// Faults of a recorded step that no query can show, each with the reason.
#pragma once

#include <span>
#include <string_view>

#include "proofs/certified/graph.h"

namespace axiscert::proofs::certified {

// A fault by its name in mutants.h, which has the number of a node of the step without fused multiply-add.
struct Equivalent {
  std::string_view step;
  int bits;
  std::string_view fault, reason;
};
std::span<const Equivalent> equivalent_faults();

// The reason, or null where none is known.
const Equivalent* reason_of_equivalence(const RecordedStep& step, std::string_view fault);

}  // namespace axiscert::proofs::certified
