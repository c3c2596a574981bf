// The last step: exact, always.
#pragma once

#include "kernel/certified/steps.h"

namespace axiscert::certified {

// Whether the sphere is separated from the triangle, for the question asked. The query is valid: finite, r >= 0;
// binary32 enters widened. In integers on the stack, in units of the least bit that is set in any of the thirteen
// numbers; no floating-point operation, so that no mode matters. About 40 KiB of stack for numbers 2^600 apart, under 4
// KiB for all of binary32.
bool exactly_separated(const double (&query)[13], Question question) noexcept;

}  // namespace axiscert::certified
