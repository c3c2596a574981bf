// The certified predicate as kernels of the registry.
#pragma once

#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/kernel.h"

namespace axiscert {

// `target` is one of available_targets(); `scalar` takes one query at a time.
template <class Real>
Implementation<Real> certified_implementation(std::string_view target, certified::Question question);

}  // namespace axiscert
