// A recorded step with one fault: a constant halved or doubled, the operands of an operation exchanged, or one of two
// conditions dropped.
#pragma once

#include <span>
#include <string_view>

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

// Faults of a recorded step that no query can show, each with the reason.

// A fault by its name, which has the number of a node of the step without fused multiply-add.
struct Equivalent {
  std::string_view step;
  int bits;
  std::string_view fault, reason;
};
std::span<const Equivalent> equivalent_faults();

// The reason, or null where none is known.
const Equivalent* reason_of_equivalence(const RecordedStep& step, std::string_view fault);

// How many faults of the certified predicate its steps' answers show.

struct StepScore {
  std::string step;  // as in graph.h
  int bits;
  std::size_t mutants = 0;
  std::vector<std::string> equivalent{};  // faults that no query can show, as equivalent_faults() argues
  std::vector<std::string> unseen{};      // others that no query showed
  // Where this is not empty an argument is wrong: faults that are argued to be equivalent and were shown.
  std::vector<std::string> contradictions{};
};

// Plants every fault in the step, one after the other, and asks it about `queries` queries (step_queries.h) until one
// answer differs. Every fault, shown or not, is in the recording, which proofs.Current compares with the committed one.
StepScore score_of(const RecordedStep& step, std::size_t queries, std::uint64_t seed);

}  // namespace axiscert::proofs::certified
