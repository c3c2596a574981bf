// The floating-point modes that the thresholds were derived for, for a scope: to nearest, gradual underflow, no traps.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace axiscert::certified {

// Engines flush subnormal numbers to zero, and some set another rounding mode or unmask traps. Where the caller's modes
// are others, they are replaced here and put back, status flags as they were; where they are these, a read of the
// register is all it costs, and flags that were raised stay raised. x87 is not used. Code in the scope has to be called
// through a pointer or be otherwise opaque, so that no operation moves out of it.
class DefaultModes {
 public:
#if defined(__SSE2__)
  DefaultModes() noexcept : callers_(_mm_getcsr()) {
    if (is_changed()) _mm_setcsr(default_modes);
  }
  ~DefaultModes() {
    if (is_changed()) _mm_setcsr(callers_);
  }
#elif defined(__aarch64__)
  DefaultModes() noexcept {
    asm volatile("mrs %0, fpcr" : "=r"(callers_));
    if (!is_changed()) return;
    asm volatile("mrs %0, fpsr" : "=r"(callers_flags_));
    asm volatile("msr fpcr, %0" ::"r"(default_modes) : "memory");
  }
  ~DefaultModes() {
    if (!is_changed()) return;
    asm volatile("msr fpcr, %0" ::"r"(callers_) : "memory");
    asm volatile("msr fpsr, %0" ::"r"(callers_flags_) : "memory");
  }
#else
#error "how this processor's floating-point modes are set is not known here"
#endif
  DefaultModes(const DefaultModes&) = delete;
  DefaultModes& operator=(const DefaultModes&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr std::uint32_t default_modes = 0x1f80, status_flags = 0x3f;
  bool is_changed() const noexcept { return (callers_ & ~status_flags) != default_modes; }
  std::uint32_t callers_;
#else
  static constexpr std::uint64_t default_modes = 0;
  bool is_changed() const noexcept { return callers_ != default_modes; }
  std::uint64_t callers_, callers_flags_;
#endif
};

}  // namespace axiscert::certified
