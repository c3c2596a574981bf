// What is wrong with a kernel at first sight, before anything is asked of it that takes time.
#pragma once

#include <string>

#include "kernel/kernel.h"

namespace axiscert {

// Asks a few hundred queries in each precision that the kernel has; a program, which may take long to start, in the
// first alone. One line: it leaves queries without an answer, and why; or its verdicts are exchanged. Empty: neither.
// Throws Error where a program fails before it is asked anything, and OracleDisagreement.
std::string first_look(const Kernel& kernel);

}  // namespace axiscert
