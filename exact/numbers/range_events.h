// Whether an evaluation stays in its format's range.
#pragma once

#include <cfenv>

#include "kernel/names.h"

namespace axiscert {

struct BitsInRange {
  ComparisonBits bits;
  // No operation that the bits depend on overflowed, underflowed or was invalid: every result was rounded in the normal
  // range or exact, so that the same operations with an unbounded exponent have the same bits.
  bool stayed;
};

// The processor's flags tell. `evaluate` has to read its operands from memory that others can reach, which keeps its
// operations between the two barriers.
template <class Evaluate>
BitsInRange bits_in_range(Evaluate&& evaluate) {
  constexpr int events = FE_OVERFLOW | FE_UNDERFLOW | FE_DIVBYZERO | FE_INVALID;
  std::feclearexcept(events);
  asm volatile("" ::: "memory");
  ComparisonBits bits = evaluate();
  asm volatile("" : "+r"(bits)::"memory");
  return {bits, std::fetestexcept(events) == 0};
}

}  // namespace axiscert
