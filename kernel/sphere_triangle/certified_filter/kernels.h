// The filters as kernels of the registry.
#pragma once

#include "kernel/kernel.h"

namespace axiscert {

enum class FilterForm : std::uint8_t { published, reduced };
template <>
inline constexpr std::size_t enum_count<FilterForm> = 2;

// `target` is one of available_targets(). The kernels give only verdicts: `separated`, `contact` or `undecided`.
template <class Real>
Implementation<Real> filter_implementation(FilterForm form, std::string_view target);

}  // namespace axiscert
