// Kernels over Highway vectors: one query per lane, dispatched at run time. Sides and bits are those of the scalar
// reference, bit for bit, on each instruction set.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Highway's names of the instruction sets that were compiled and that this machine supports, best first.
const std::vector<std::string>& simd_targets();

// Calls visit(name) with each of simd_targets() chosen in turn, so that HWY_DYNAMIC_DISPATCH finds its form. Callers
// take turns, because Highway keeps its choice in a global; the choice is restored at the end.
void for_each_simd_target(const std::function<void(const std::string&)>& visit);

// A table with a form for each instruction set; make() is called once under each.
template <class Form>
class SimdTable {
 public:
  template <class Make>
  explicit SimdTable(Make&& make) {
    for_each_simd_target([&](const std::string& name) { by_target_.emplace(name, make()); });
  }
  // `target` is one of simd_targets().
  const Form& on(std::string_view target) const { return by_target_.find(target)->second; }

 private:
  std::map<std::string, Form, std::less<>> by_target_;
};

// One set of formulae on every instruction set.
class SimdForms {
 public:
  SimdForms(Implementation<float> (*binary32)(Strictness), Implementation<double> (*binary64)(Strictness));
  // `target` is one of simd_targets(); strict or nonstrict.
  template <class Real>
  Implementation<Real> on(std::string_view target, Strictness strictness) const {
    const Forms& forms = table_.on(target);
    if constexpr (sizeof(Real) == 4) return forms.binary32[strictness];
    else return forms.binary64[strictness];
  }

 private:
  struct Forms {
    EnumArray<Strictness, Implementation<float>> binary32;
    EnumArray<Strictness, Implementation<double>> binary64;
  };
  SimdTable<Forms> table_;
};

// Whether simd.cpp lists a vector form of these formulae.
bool has_simd_form(Formulae formulae);
// That form; null for formulae without one, or where the machine has no instruction set for it.
const SimdForms* simd_forms(Formulae formulae);

// A kernel of any predicate over Highway's vectors: one query per lane, dispatched at run time, its answers those of
// the scalar form bit for bit on each instruction set.

// One kernel on every instruction set; `target` is one of simd_targets().
class LaneForms {
 public:
  LaneForms(Implementation<float> (*binary32)(), Implementation<double> (*binary64)())
      : table_([&] {
          return Forms{binary32(), binary64()};
        }) {}
  template <class Real>
  Implementation<Real> on(std::string_view target) const {
    if constexpr (sizeof(Real) == 4) return table_.on(target).binary32;
    else return table_.on(target).binary64;
  }

 private:
  struct Forms {
    Implementation<float> binary32;
    Implementation<double> binary64;
  };
  SimdTable<Forms> table_;
};

// The kernel, and in these forms on every target that is not scalar, with the scalar form's measures.
inline Kernel with_lane_forms(Kernel kernel, const LaneForms& (*forms)()) {
  if (simd_targets().empty()) return kernel;
  kernel.has_simd = true;
  const auto in_lanes = [=]<class Real>(const Implementation<Real>& scalar, std::string_view target) {
    if (target == scalar_target) return scalar;
    Implementation<Real> there = forms().on<Real>(target);
    there.measure = scalar.measure;
    return there;
  };
  kernel.binary32 = [=, scalar = kernel.binary32](std::string_view target) { return in_lanes(scalar(target), target); };
  kernel.binary64 = [=, scalar = kernel.binary64](std::string_view target) { return in_lanes(scalar(target), target); };
  return kernel;
}

}  // namespace axiscert
