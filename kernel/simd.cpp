#include "kernel/simd.h"

#define HWY_COMPILE_ALL_ATTAINABLE
#include "hwy/highway.h"

namespace axiscert {
namespace {

// Calls visit(name) with each instruction set chosen, best first. Highway keeps its choice in a global: it is left as
// it was.
template <class Visit>
void for_each_simd_target(Visit&& visit) {
  // HWY_SCALAR is no instruction set: the scalar reference stands for it.
  const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS & ~std::int64_t{HWY_SCALAR};
  for (std::int64_t rest = supported; rest != 0; rest &= rest - 1) {
    const std::int64_t target = rest & -rest;  // a lower bit is a better instruction set
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    visit(std::string(hwy::TargetName(target)));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace

const std::vector<std::string>& simd_targets() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for_each_simd_target([&](std::string name) { all.push_back(std::move(name)); });
    return all;
  }();
  return names;
}

SimdForms::SimdForms(Implementation<float> (*binary32)(Strictness), Implementation<double> (*binary64)(Strictness)) {
  for_each_simd_target([&](const std::string& name) {
    Forms& forms = by_target_[name];
    for (const Strictness s : {Strictness::strict, Strictness::nonstrict}) {
      forms.binary32[static_cast<std::size_t>(s)] = binary32(s);
      forms.binary64[static_cast<std::size_t>(s)] = binary64(s);
    }
  });
}

}  // namespace axiscert
