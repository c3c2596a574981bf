// Start-up proof by computation that a target's kernels round every operation, once, to nearest, with subnormals.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/kernel.h"

namespace axiscert {

// Runs a kernel that claims the reference's sides on fixed queries and compares its sides, bit for bit, with an
// evaluation that stores every single result to memory, which no compiler can contract, and whose own mode (round to
// nearest, gradual underflow) is checked against constants. Returns what differs: kernel, comparison, query and both
// values; nothing if all agree.
template <class Real>
std::optional<std::string> self_check(const Kernel& kernel, std::string_view target);

// Every registered kernel that claims the reference's sides, in both precisions, on `target` where it has a form of its
// own there; throws HarnessFault with what differs.
void require_uncontracted(std::string_view target);

}  // namespace axiscert
