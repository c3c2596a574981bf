// The kernels that exist: one line each.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "kernel/error.h"
#include "kernel/kernel.h"
#include "kernel/scalar.h"
#include "kernel/simd.h"

namespace axiscert {
namespace {

template <class Real, Strictness strictness>
Implementation<Real> sat7(std::string_view target) {
  return target == scalar_target ? scalar_implementation<Real>(strictness)
                                 : simd_implementation<Real>(strictness, target);
}

constexpr Kernel registry[] = {
    {"published", "the article's last block: sixteen strict comparisons, seven axes", Strictness::strict,
     sat7<float, Strictness::strict>, sat7<double, Strictness::strict>},
    {"nonstrict", "the same with >= in the nine side comparisons: right for degenerate triangles too",
     Strictness::nonstrict, sat7<float, Strictness::nonstrict>, sat7<double, Strictness::nonstrict>},
};

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::span<const Kernel> kernels() { return registry; }

const Kernel& find_kernel(std::string_view id) {
  std::vector<std::string_view> known;
  for (const Kernel& kernel : registry) {
    if (kernel.id == id) return kernel;
    known.push_back(kernel.id);
  }
  throw Error(fmt::format("unknown kernel '{}'; kernels: {}", id, fmt::join(known, ", ")));
}

std::vector<std::string> available_targets() {
  std::vector<std::string> names = simd_targets();
  names.emplace_back(scalar_target);
  return names;
}

std::string resolve_target(std::string_view name) {
  const std::vector<std::string> available = available_targets();
  if (same_letters(name, "auto")) return available.front();
  for (const std::string& target : available) {
    if (same_letters(name, target)) return target;
  }
  throw Error(fmt::format("target '{}' is not on this machine; targets: auto, {}", name, fmt::join(available, ", ")));
}

}  // namespace axiscert
