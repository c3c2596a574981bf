/* Turns flush-to-zero and denormals-are-zero on. */
#include <stdint.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

static void flush_to_zero(void) {
#if defined(__SSE2__)
  _mm_setcsr(_mm_getcsr() | 0x8040);
#elif defined(__aarch64__)
  uint64_t control;
  __asm__ volatile("mrs %0, fpcr" : "=r"(control));
  __asm__ volatile("msr fpcr, %0" : : "r"(control | 1u << 24));
#else
#error "how this processor flushes subnormal numbers to zero is not known here"
#endif
}
