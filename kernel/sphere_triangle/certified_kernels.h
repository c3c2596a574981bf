// The certified predicate, and the contacts of libaxiscert, as kernels of the registry.
#pragma once

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/certified/steps.h"

namespace axiscert {

// `target` is one of available_targets(); `scalar` takes one query at a time.
template <class Real>
Implementation<Real> certified_implementation(std::string_view target, certified::Question question);

// The certified answers to the closed sphere, with all of the predicate's measures. `target` is one of
// available_targets(); `scalar` takes one query at a time.
template <class Real>
Implementation<Real> contact_implementation(std::string_view target);

}  // namespace axiscert
