// R-infinity over a batch by SIMD: the comparison bits of a set of formulae in plain arithmetic with an unbounded
// exponent.
#pragma once

#include <string_view>

#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// Writes the comparison bits of each query of the batch; those of an invalid query are unspecified. The processor has
// to round to nearest, and must not flush subnormals.
template <class Real>
using RangeFreeBits = void (*)(const QueryColumns<Real>& batch, ComparisonBits* out);

// On one of simd_targets(), strict or nonstrict; null for formulae that have no SIMD form
// (kernel/sphere_triangle/forms/simd.h). On every instruction set the bits are those of unbounded()
// (exact/sphere_triangle/unbounded/unbounded.h).
template <class Real>
RangeFreeBits<Real> range_free_on(std::string_view target, Formulae formulae, Strictness strictness);
template <>
RangeFreeBits<float> range_free_on<float>(std::string_view target, Formulae formulae, Strictness strictness);
template <>
RangeFreeBits<double> range_free_on<double>(std::string_view target, Formulae formulae, Strictness strictness);

}  // namespace axiscert
