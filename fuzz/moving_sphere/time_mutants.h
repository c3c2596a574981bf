// Kernels that show a verdict and a time of the first contact alone: one that is right, by exact arithmetic, and the
// same with one fault each. A harness that judges times has to tell the right one from every other.
#pragma once

#include <string_view>

#include "kernel/base/enums.h"
#include "kernel/kernel.h"

namespace axiscert {

// t* is the exact first time, `best` the greatest number of the precision that is not later. X(name, description)
#define AXISCERT_TIME_FAULTS(X)                                                                                 \
  X(late, "the number after the best")                                                                          \
  X(early, "the number before the best, where that is not 0")                                                   \
  X(nearest, "t* rounded to the nearest number, and not down")                                                  \
  X(other_root, "b + sqrt for b - sqrt: where the sphere leaves what it met; no contact where that is after 1") \
  X(gate_off, "the root of any feature counts, whether or not that is nearest then")                            \
  X(gate_reversed, "the sides of a gate exchanged: a root counts where its feature is not nearest")             \
  X(from_the_end, "1 - t for t")                                                                                \
  X(length, "t |D|, a length, for t")                                                                           \
  X(none, "no time beside a contact")                                                                           \
  X(negative, "-1 for t")                                                                                       \
  X(infinite, "infinity for t")

enum class TimeFault : std::uint8_t {
  right,  // no fault
#define AXISCERT_NAME(name, what) name,
  AXISCERT_TIME_FAULTS(AXISCERT_NAME)
#undef AXISCERT_NAME
};
template <>
inline constexpr std::size_t enum_count<TimeFault> = index_of(TimeFault::infinite) + 1;

struct TimeFaultText {
  std::string_view name, what;
};
inline constexpr EnumArray<TimeFault, TimeFaultText> time_fault_texts = {TimeFaultText{"right", "no fault"},
#define AXISCERT_TEXT(name, what) TimeFaultText{#name, what},
                                                                         AXISCERT_TIME_FAULTS(AXISCERT_TEXT)
#undef AXISCERT_TEXT
};

// Its id is moving-sphere/exact-time~FAULT. It takes a few hundred times as long as a kernel in floats.
Kernel time_mutant(TimeFault fault);

}  // namespace axiscert
