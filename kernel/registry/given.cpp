#include "kernel/registry/given.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <mutex>

#include "kernel/base/error.h"

namespace axiscert {
namespace {

struct GivenKernels {
  std::mutex mutex;
  std::deque<Kernel> all;  // the newest of an id is the last
};
GivenKernels& given_kernels() {
  static GivenKernels given;
  return given;
}

}  // namespace

const Kernel& give_kernel(Kernel kernel) {
  if (std::ranges::any_of(kernels(), [&](const Kernel& own) { return own.id == kernel.id; }))
    throw Error(fmt::format("kernel '{}': that is a built-in kernel; give another name", kernel.id));
  GivenKernels& given = given_kernels();
  const std::lock_guard lock(given.mutex);
  return given.all.emplace_back(std::move(kernel));
}

const Kernel* given_kernel(std::string_view id) {
  GivenKernels& given = given_kernels();
  const std::lock_guard lock(given.mutex);
  const auto found = std::find_if(given.all.rbegin(), given.all.rend(), [&](const Kernel& k) { return k.id == id; });
  return found == given.all.rend() ? nullptr : &*found;
}

}  // namespace axiscert
