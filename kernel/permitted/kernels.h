// Kernels of the worst that permissions allow: of a set of formulae, KERNEL+PART-misses answers separated where any
// permitted evaluation does, and KERNEL+PART-invents contact where any does. What the former misses, and what the
// latter invents, a compiler that has these permissions can make of the formulae; nothing else.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert::permitted {

// The names that follow '+': PART-misses and PART-invents of every part (permissions.h).
std::vector<std::string> names();
// The kernel of that name of `rung`; nothing where the name is none. Throws Error where the rung's formulae are not
// known here, as those that take roots.
std::optional<Kernel> kernel(std::string_view id, const Kernel& rung, std::string_view name);

// The evaluation by which such a kernel gives the verdict that it looks for: a line for each comparison that decides,
// NAME holds: LHS = VALUE > RHS = VALUE, with both sides as expressions of the columns; of formulae that branch a line
// for each comparison on the way. Empty for any other kernel, and where no evaluation gives that verdict.
std::vector<std::string> evaluation(const Kernel& kernel, const Numbers<float>& query);

}  // namespace axiscert::permitted
