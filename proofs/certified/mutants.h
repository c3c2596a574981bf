// A recorded step with one fault: a constant halved or doubled, the operands of an operation exchanged, or one of two
// conditions dropped.
#pragma once

#include "proofs/certified/graph.h"

namespace axiscert::proofs::certified {

struct Mutant {
  std::string name;  // the node and its fault
  Index at;
  Node node;  // in place of the node there
};
// Every such fault of what the results need. The operands of a sum or a product are not exchanged: rounding does not
// depend on their order.
std::vector<Mutant> mutants_of(const RecordedStep& step);
RecordedStep with(const Mutant& mutant, RecordedStep step);

}  // namespace axiscert::proofs::certified
