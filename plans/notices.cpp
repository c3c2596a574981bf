#include "plans/notices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "fuzz/confirm/record.h"
#include "fuzz/diagnosis/beside_runs.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

TakeNotice& taker() {
  static TakeNotice take;
  return take;
}

}  // namespace

void set_notices(TakeNotice take) { taker() = std::move(take); }

void take_notice(const std::string& line) {
  if (taker()) taker()(line);
  else fmt::print(stderr, "axiscert: {}\n", line);
}

namespace {

bool is_loaded(const Kernel& kernel) { return kernel.has(Precision::binary32) || kernel.has(Precision::binary64); }

}  // namespace

void print_first_look(const std::vector<const Kernel*>& kernels) {
  // Where others take long, before them; where there are none, the end comes at once and says it.
  const bool others_are_asked = std::any_of(kernels.begin(), kernels.end(), [](auto* one) { return is_loaded(*one); });
  for (const Kernel* kernel : kernels) {
    if (is_loaded(*kernel)) print_first_look(*kernel);
    else if (others_are_asked) notice("kernel {}: it could not be loaded{}", kernel->id, why_not_loaded(*kernel));
  }
}

void print_first_look(const Kernel& kernel) {
  if (!plugin::is_given_by_file(kernel.id) || !is_loaded(kernel)) return;
  if (const std::string found = first_look(kernel); !found.empty()) notice("kernel {}: {}", kernel.id, found);
}

}  // namespace axiscert
