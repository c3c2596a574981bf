/* Turns flush-to-zero and denormals-are-zero on and leaves them on; what it has answered by then is right. */
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

#include "kernel/plugin/misbehaving/right.h"

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

static void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  answer_rightly(batch, answers);
  flush_to_zero();
}
MISBEHAVING("flush_to_zero", run)
