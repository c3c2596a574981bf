#include "cli/first_look.h"

#include <fmt/format.h>

#include <cstdio>

#include "fuzz/confirm/record.h"
#include "fuzz/diagnosis/first_look.h"
#include "kernel/plugin/load.h"

namespace axiscert {

void print_first_look(const std::vector<const Kernel*>& kernels) {
  for (const Kernel* kernel : kernels) print_first_look(*kernel);
}

void print_first_look(const Kernel& kernel) {
  if (!plugin::is_given_by_file(kernel.id)) return;
  if (!kernel.has(Precision::binary32) && !kernel.has(Precision::binary64)) {
    fmt::print(stderr, "axiscert: kernel {}: it could not be loaded{}\n", kernel.id, why_not_loaded(kernel));
    return;
  }
  if (const std::string found = first_look(kernel); !found.empty())
    fmt::print(stderr, "axiscert: kernel {}: {}\n", kernel.id, found);
}

}  // namespace axiscert
