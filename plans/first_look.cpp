#include "plans/first_look.h"

#include <fmt/format.h>

#include "fuzz/confirm/record.h"
#include "fuzz/diagnosis/first_look.h"
#include "kernel/plugin/load.h"
#include "plans/notices.h"

namespace axiscert {

void print_first_look(const std::vector<const Kernel*>& kernels) {
  for (const Kernel* kernel : kernels) print_first_look(*kernel);
}

void print_first_look(const Kernel& kernel) {
  if (!plugin::is_given_by_file(kernel.id)) return;
  if (!kernel.has(Precision::binary32) && !kernel.has(Precision::binary64)) {
    notice("kernel {}: it could not be loaded{}", kernel.id, why_not_loaded(kernel));
    return;
  }
  if (const std::string found = first_look(kernel); !found.empty()) notice("kernel {}: {}", kernel.id, found);
}

}  // namespace axiscert
