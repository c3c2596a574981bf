#include "kernel/sphere_triangle/forms/simd.h"

#include <mutex>

#define HWY_COMPILE_ALL_ATTAINABLE
#include "hwy/highway.h"

// The formulae that have a SIMD form, one line each: X(NAME) is `simd_NAME`, which simd_NAME.cpp defines. Every kernel
// of the registry that is `evaluated` from them runs it on the targets that are not scalar.
#define AXISCERT_SIMD_FORMS(X) \
  X(published)                 \
  X(reduced)

namespace axiscert {

#define AXISCERT_DECLARE(name) const SimdForms& simd_##name();
AXISCERT_SIMD_FORMS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

void for_each_simd_target(const std::function<void(const std::string&)>& visit) {
  static std::mutex one_at_a_time;
  const std::lock_guard lock(one_at_a_time);
  // HWY_SCALAR is not an instruction set: the scalar reference takes its place.
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

const std::vector<std::string>& simd_targets() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for_each_simd_target([&](const std::string& name) { all.push_back(name); });
    return all;
  }();
  return names;
}

bool has_simd_form(Formulae formulae) {
#define AXISCERT_IS(name) || formulae == Formulae::name
  return false AXISCERT_SIMD_FORMS(AXISCERT_IS);
#undef AXISCERT_IS
}

const SimdForms* simd_forms(Formulae formulae) {
  if (simd_targets().empty()) return nullptr;
#define AXISCERT_FORM(name) \
  if (formulae == Formulae::name) return &simd_##name();
  AXISCERT_SIMD_FORMS(AXISCERT_FORM)
#undef AXISCERT_FORM
  return nullptr;
}

SimdForms::SimdForms(Implementation<float> (*binary32)(Strictness), Implementation<double> (*binary64)(Strictness))
    : table_([&] {
        Forms forms;
        for (const Strictness s : {Strictness::strict, Strictness::nonstrict}) {
          forms.binary32[s] = binary32(s);
          forms.binary64[s] = binary64(s);
        }
        return forms;
      }) {}

}  // namespace axiscert
