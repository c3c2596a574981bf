// R and R-infinity over a batch by SIMD.
#pragma once

#include <optional>
#include <string_view>

#include "exact/sphere_triangle/unbounded.h"
#include "kernel/formulae_list.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
// R-infinity over a batch by SIMD: the comparison bits of a set of formulae in plain arithmetic with an unbounded
// exponent.

// Writes the comparison bits of each query of the batch; those of an invalid query are unspecified. The processor has
// to round to nearest, and must not flush subnormals.
template <class Real>
using RangeFreeBits = void (*)(const QueryColumns<Real>& batch, ComparisonBits* out);

// On one of simd_targets(), strict or nonstrict; null for formulae that have no SIMD form
// (kernel/sphere_triangle/forms/simd.h). On every instruction set the bits are those of unbounded()
// (exact/sphere_triangle/unbounded.h).
template <class Real>
RangeFreeBits<Real> range_free_on(std::string_view target, Formulae formulae, Strictness strictness);
template <>
RangeFreeBits<float> range_free_on<float>(std::string_view target, Formulae formulae, Strictness strictness);
template <>
RangeFreeBits<double> range_free_on<double>(std::string_view target, Formulae formulae, Strictness strictness);

// The comparison bits of the outcomes in exact/sphere_triangle/unbounded.h.
struct RoundedBits {
  ComparisonBits range_free, reference;
  RoundedDecisions outcomes() const { return {outcome_of(range_free), outcome_of(reference)}; }
};

// The bits of the scalar reference that a kernel claims, and those with an unbounded exponent, by SIMD forms of the
// same formulae on the best instruction set. Tests compare them with the scalar ones, bit for bit, and so does each run
// on a sample of its queries.
template <class Real>
class ReferenceBatch {
 public:
  explicit ReferenceBatch(const Kernel& kernel);
  void evaluate(const QueryColumns<Real>& batch);
  // The decisions of both; empty if the formulae have no such form.
  std::optional<RoundedBits> rounded(std::size_t i) const {
    if (bits_.empty()) return std::nullopt;
    return RoundedBits{range_free(i), bits_[i]};
  }
  // The bits of both if they are the same; else empty.
  std::optional<ComparisonBits> shared(std::size_t i) const {
    if (bits_.empty() || bits_[i] != range_free(i)) return std::nullopt;
    return bits_[i];
  }

 private:
  // If no operation over- or underflowed in a block of queries, the two are the same
  // (exact/sphere_triangle/unbounded.h).
  static constexpr std::size_t block = 64;
  ComparisonBits range_free(std::size_t i) const { return left_range_[i / block] ? range_free_[i] : bits_[i]; }

  std::function<void(const QueryColumns<Real>& batch, ComparisonBits* out)> form_;
  RangeFreeBits<Real> range_free_form_ = nullptr;
  std::vector<ComparisonBits> bits_, range_free_;  // range_free_: for the blocks that left the range
  std::vector<char> left_range_;                   // per block
};

}  // namespace axiscert
