// The steps of the certified predicate one by one, as they run: for tests that compare them with the recorded programs.
#pragma once

#include <cstddef>
#include <string_view>

#include "proofs/certified/evaluate.h"

namespace axiscert::proofs {

using certified::StepAnswers;

// Asks `size` queries, in columns ax ay az bx by bz cx cy cz px py pz r, of a recorded step's name.
struct StepForms {
  bool fused;         // whether the instruction set has fused multiply-add
  std::size_t lanes;  // doubles in a vector; a single pair takes four of its numbers
  void (*step32)(std::string_view step, const float* const* columns, std::size_t size, StepAnswers* out);
  void (*step64)(std::string_view step, const double* const* columns, std::size_t size, StepAnswers* out);
};
// For the instruction set that Highway has chosen.
StepForms chosen_step_forms();

}  // namespace axiscert::proofs
