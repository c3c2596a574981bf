// Check at start-up, by computation, that a target's kernels round every operation once, to nearest, with subnormal
// numbers.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/kernel.h"

namespace axiscert {

// Runs a kernel that claims the reference's sides on fixed queries and compares its sides, bit for bit, with an
// evaluation that stores every single result to memory, which no compiler can contract, and whose own mode (round to
// nearest, gradual underflow) is checked against constants. Returns the difference as kernel, comparison, query and
// both values; empty if all agree.
template <class Real>
std::optional<std::string> self_check(const Kernel& kernel, std::string_view target);

// Runs self_check for every registered kernel that claims the reference's sides, in both precisions, on `target` if the
// kernel has a form of its own there; throws HarnessFault with the difference.
void require_uncontracted(std::string_view target);

}  // namespace axiscert
