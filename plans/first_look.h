// The first line of every command about a kernel that is not fit to be asked.
#pragma once

#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// Looks at each kernel of a user's file, and prints on standard error what is wrong at first sight: a line, before
// anything else is printed. The command goes on, and says what comes of it.
void print_first_look(const std::vector<const Kernel*>& kernels);
void print_first_look(const Kernel& kernel);

}  // namespace axiscert
