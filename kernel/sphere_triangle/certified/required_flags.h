// Refuses the compiler's flags under which the steps are not what was proved of them, where the compiler tells. Neither
// g++ nor clang tells whether it contracts a b + c (-ffp-contract=off), nor clang the parts of -ffast-math but
// -ffinite-math-only; self_check.h looks at these.
#pragma once

#include <cfloat>

// g++ has 0 for __GCC_IEC_559 under each part of -ffast-math that changes a value: -fassociative-math,
// -freciprocal-math, -ffinite-math-only, -fno-signed-zeros.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "libaxiscert is right in IEEE 754 arithmetic: compile it without -ffast-math, -Ofast and the parts of these"
#endif
// x87 has more bits and a wider range than double: what loses a bit where it is stored seems not to.
#if FLT_EVAL_METHOD != 0
#error "libaxiscert is right where each operation is rounded to its type: compile it for SSE2 (-mfpmath=sse)"
#endif
