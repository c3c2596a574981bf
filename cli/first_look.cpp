#include "cli/first_look.h"

#include <fmt/format.h>

#include <cstdio>

#include "fuzz/diagnosis/first_look.h"
#include "kernel/plugin/load.h"

namespace axiscert {

void print_first_look(const std::vector<const Kernel*>& kernels) {
  for (const Kernel* kernel : kernels) print_first_look(*kernel);
}

void print_first_look(const Kernel& kernel) {
  if (!plugin::is_given_by_file(kernel.id)) return;
  if (const std::string found = first_look(kernel); !found.empty())
    fmt::print(stderr, "axiscert: kernel {}: {}\n", kernel.id, found);
}

}  // namespace axiscert
