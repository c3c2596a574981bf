// How many faults of the certified predicate its steps' answers show.
#pragma once

#include "proofs/certified/mutants.h"

namespace axiscert::proofs::certified {

struct StepScore {
  std::string step;  // as in graph.h
  int bits;
  std::size_t mutants = 0;
  std::vector<std::string> equivalent{};  // faults that no query can show, as equivalent.h argues
  std::vector<std::string> unseen{};      // others that no query showed
  // Where this is not empty an argument is wrong: faults that are argued to be equivalent and were shown.
  std::vector<std::string> contradictions{};
};

// Plants every fault in the step, one after the other, and asks it about `queries` queries (step_queries.h) until one
// answer differs. Every fault, shown or not, is in the recording, which proofs.Current compares with the committed one.
StepScore score_of(const RecordedStep& step, std::size_t queries, std::uint64_t seed);

}  // namespace axiscert::proofs::certified
