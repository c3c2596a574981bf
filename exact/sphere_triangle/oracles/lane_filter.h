// The first step of the judge, over SIMD lanes: the conclusions about a batch that need no exact arithmetic. Each
// answer is certain or missing; margins-inl.h derives the bounds.
#pragma once

#include <string_view>
#include <vector>

#include "exact/judge/batch_oracle.h"
#include "exact/sphere_triangle/oracles/signs.h"
#include "kernel/kernel.h"

namespace axiscert {

// The filter's conclusions about the signs of one query.
struct FilteredSigns {
  Signs signs;
  // the comparisons for which `signs` hold; if not all sixteen, the next step decides the query
  SignBits certain = 0;
  bool is_valid = false;  // finite, r >= 0
  // all signs certain, some margin within 2^10 times its bound; checked in one query of sixteen
  bool is_close = false;
  bool is_decided() const { return is_valid && certain == 0xffff; }
};

// Queries come in blocks of eight; the last of each sixteen blocks is checked for close calls.
inline constexpr std::size_t close_call_block = 8, close_call_stride = 16;

// One comparison of one query whose error may be greater than its threshold: lower <= error <= upper, in u. The upper
// bound is infinite if the scale may be zero, and both are if a computed side is not finite.
struct SuspectError {
  std::size_t query, comparison;
  double lower, upper;
};

// By comparison, in u.
using ErrorThresholds = std::array<double, comparison_count>;

// The filter on one instruction set.
template <class Real>
struct Filter {
  // `out` holds batch.size entries.
  void (*signs_with_fault)(const QueryColumns<Real>& batch, FilterFault fault, FilteredSigns* out);
  // Appends every error of the computed sides, of the published formulae or of a reduced form, that is not certainly
  // within its threshold.
  void (*errors)(const QueryColumns<Real>& batch, const Answers<Real>& computed, bool reduced,
                 const ErrorThresholds& thresholds, std::vector<SuspectError>& suspects);
  FilterFault planted = FilterFault::none;

  void signs(const QueryColumns<Real>& batch, FilteredSigns* out) const { signs_with_fault(batch, planted, out); }
};

// `target` is one of simd_targets(), or `scalar`, which selects the best of them. Conclusions are true on each target;
// how many there are may differ.
template <class Real>
Filter<Real> filter_on(std::string_view target, FilterFault fault = FilterFault::none);
template <>
Filter<float> filter_on<float>(std::string_view target, FilterFault fault);
template <>
Filter<double> filter_on<double>(std::string_view target, FilterFault fault);

}  // namespace axiscert
