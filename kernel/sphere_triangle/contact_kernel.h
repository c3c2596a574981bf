// The contacts of libaxiscert as a kernel of the registry.
#pragma once

#include "kernel/kernel.h"

namespace axiscert {

// The certified answers to the closed sphere, with all of the predicate's measures. `target` is one of
// available_targets(); `scalar` takes one query at a time.
template <class Real>
Implementation<Real> contact_implementation(std::string_view target);

}  // namespace axiscert
