#include "exact/sphere_triangle/reference_batch.h"

#include <algorithm>
#include <cfenv>

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {

template <class Real>
ReferenceBatch<Real>::ReferenceBatch(const Kernel& kernel) {
  const bool has_form = kernel.arithmetic == Arithmetic::plain && kernel.strictness != Strictness::not_less;
  const SimdForms* forms = has_form ? simd_forms(formulae_of(kernel)) : nullptr;
  if (!forms) return;
  range_free_form_ = range_free_on<Real>(simd_targets().front(), formulae_of(kernel), kernel.strictness);
  if (!range_free_form_) return;  // formulae with a form of R alone: both are evaluated one query at a time
  form_ = forms->on<Real>(simd_targets().front(), kernel.strictness).bits;
}

template <class Real>
void ReferenceBatch<Real>::evaluate(const QueryColumns<Real>& batch) {
  if (!form_) return;
  bits_.resize(batch.size);
  left_range_.assign((batch.size + block - 1) / block, false);
  constexpr int events = FE_OVERFLOW | FE_UNDERFLOW;
  std::feclearexcept(events);
  form_(batch, bits_.data());
  if (std::fetestexcept(events) == 0) return;
  range_free_.resize(batch.size);
  for (std::size_t i = 0; i < left_range_.size(); ++i) {
    QueryColumns<Real> part;
    part.size = std::min(block, batch.size - i * block);
    part.count = coordinate_count;
    for (std::size_t k = 0; k < coordinate_count; ++k) part.column[k] = batch.column[k] + i * block;
    std::feclearexcept(events);
    form_(part, bits_.data() + i * block);
    left_range_[i] = std::fetestexcept(events) != 0;
    if (left_range_[i]) range_free_form_(part, range_free_.data() + i * block);
  }
}

template class ReferenceBatch<float>;
template class ReferenceBatch<double>;

}  // namespace axiscert
