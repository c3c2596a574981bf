// R over a batch by SIMD, and where R-infinity is certainly the same.
#pragma once

#include <optional>

#include "kernel/kernel.h"

namespace axiscert {

// The bits of the scalar reference that a kernel claims, by the SIMD form of the same formulae on the best instruction
// set: tests hold the two to each other, bit for bit, and so does each run on a sample of its queries.
template <class Real>
class ReferenceBatch {
 public:
  explicit ReferenceBatch(const Kernel& kernel);
  void evaluate(const QueryColumns<Real>& batch);
  // Whether the formulae have such a form. Without one nothing is shared.
  bool has_form() const { return form_ != nullptr; }
  // The bits of R and of R-infinity. Nothing where the formulae have no such form, or where an operation over- or
  // underflowed in one of the 64 neighbouring queries, so that the two may differ (exact/unbounded.h).
  std::optional<ComparisonBits> shared(std::size_t i) const {
    if (bits_.empty() || left_range(i)) return std::nullopt;
    return bits_[i];
  }
  // The same in two parts, for loops over a batch.
  const ComparisonBits* bits() const { return bits_.data(); }
  bool left_range(std::size_t i) const { return left_range_[i / block]; }

 private:
  static constexpr std::size_t block = 64;
  std::function<void(const QueryColumns<Real>& batch, ComparisonBits* out)> form_;
  std::vector<ComparisonBits> bits_;
  std::vector<char> left_range_;  // by block
};

}  // namespace axiscert
