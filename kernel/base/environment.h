// The processor's floating-point modes, set for a scope.
#pragma once

#include <cfenv>
#include <cstdint>

#include "kernel/base/enums.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace axiscert {

enum class Rounding : std::uint8_t { nearest, upward, downward, toward_zero };
template <>
inline constexpr std::size_t enum_count<Rounding> = 4;

// Sets a rounding mode and, if `flush`, makes subnormal results and operands zero (FTZ and DAZ); restores both. Code in
// its scope must keep its operations there: call a function that reads its operands from memory and writes its results
// there, compiled with -frounding-math.
class FloatingEnvironment {
 public:
  FloatingEnvironment(Rounding rounding, bool flush) : rounding_(std::fegetround()), control_(control()) {
    constexpr EnumArray<Rounding, int> modes = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    std::fesetround(modes[rounding]);
    if (flush) set_control(control() | flush_bits);
  }
  ~FloatingEnvironment() {
    // The status flags that the scope raised stay raised.
    if ((control_ & flush_bits) != (control() & flush_bits)) {
      set_control((control() & ~flush_bits) | (control_ & flush_bits));
    }
    std::fesetround(rounding_);
  }
  FloatingEnvironment(const FloatingEnvironment&) = delete;
  FloatingEnvironment& operator=(const FloatingEnvironment&) = delete;

  // The present value of the register that holds the modes.
#if defined(__SSE2__)
  static std::uint64_t control() { return _mm_getcsr(); }
#elif defined(__aarch64__)
  static std::uint64_t control() {
    std::uint64_t bits;
    asm volatile("mrs %0, fpcr" : "=r"(bits));
    return bits;
  }
#endif

 private:
#if defined(__SSE2__)
  static constexpr std::uint64_t flush_bits = 0x8040;  // FTZ, DAZ
  static void set_control(std::uint64_t bits) { _mm_setcsr(static_cast<unsigned>(bits)); }
#elif defined(__aarch64__)
  static constexpr std::uint64_t flush_bits = std::uint64_t{1} << 24;  // FZ: results and operands
  static void set_control(std::uint64_t bits) { asm volatile("msr fpcr, %0" ::"r"(bits)); }
#else
#error "how this processor flushes subnormal numbers to zero is not known here"
#endif

  int rounding_;
  std::uint64_t control_;
};

}  // namespace axiscert
