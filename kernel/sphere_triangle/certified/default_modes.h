// Sets, for a scope, the floating-point modes for which the thresholds were derived: round to nearest, gradual
// underflow, no traps.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace axiscert::certified {

// Engines flush subnormal numbers to zero, and some set another rounding mode or unmask traps. If the caller's modes
// differ, they are replaced here and restored at the end, with the status flags as they were. If they do not differ,
// the only cost is one read of the register, and flags raised in the scope stay raised. x87 is not used. Code in the
// scope has to be called through a pointer or be opaque in another way, so that no operation moves out of the scope.
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
#error "setting the floating-point modes is not implemented for this processor"
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
