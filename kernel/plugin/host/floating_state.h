// The floating-point modes of the thread, to see whether a call left them changed.
#pragma once

#include "kernel/base/environment.h"
#include "kernel/plugin/shared_memory.h"

namespace axiscert::plugin {

struct FloatingState {
  std::uint64_t control;  // MXCSR, or FPCR
  std::uint16_t x87 = 0;  // its control word
};

inline FloatingState floating_state() {
  FloatingState state{FloatingEnvironment::control()};
#if defined(__x86_64__)
  asm volatile("fnstcw %0" : "=m"(state.x87));
#endif
  return state;
}

inline std::uint32_t changes(const FloatingState& before, const FloatingState& after) {
  const std::uint64_t difference = before.control ^ after.control;
  const std::uint16_t x87 = before.x87 ^ after.x87;
#if defined(__SSE2__)
  constexpr std::uint64_t status = 0x3f, rounding = 0x6000, flushing = 0x8040, traps = 0x1f80;
#elif defined(__aarch64__)
  constexpr std::uint64_t status = 0, rounding = 0xc00000, flushing = 0x1000000, traps = 0x9f00;
#endif
  constexpr std::uint16_t x87_rounding = 0x0c00, x87_traps = 0x003f;
  std::uint32_t changed = 0;
  if ((difference & rounding) || (x87 & x87_rounding)) changed |= changed_rounding;
  if (difference & flushing) changed |= changed_flushing;
  if ((difference & traps) || (x87 & x87_traps)) changed |= changed_traps;
  if ((difference & ~(status | rounding | flushing | traps)) || (x87 & ~(x87_rounding | x87_traps))) {
    changed |= changed_other;
  }
  return changed;
}

}  // namespace axiscert::plugin
