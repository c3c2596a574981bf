// The shortest way to an answer: every query straight to the exact step.
#pragma once

#include "kernel/sphere_triangle/certified/steps.h"

namespace axiscert::certified {

// Forms without vectors, for the closed and the open sphere; `conservative` counts as the closed one. The caller has to
// set the modes of kernel/sphere_triangle/certified/default_modes.h.
const Forms& exact_only_forms() noexcept;

}  // namespace axiscert::certified
