// Kernels that the program itself has, as functions: find_kernel() finds them by their ids.
#pragma once

#include <string_view>

#include "kernel/kernel.h"

namespace axiscert {

// From here on the kernel is found by its id, in place of one that was given before with the same. References to that
// one stay valid: all do for the life of the program. Throws Error where the id is that of a kernel of the registry.
const Kernel& give_kernel(Kernel kernel);
// Null where none was given.
const Kernel* given_kernel(std::string_view id);

}  // namespace axiscert
