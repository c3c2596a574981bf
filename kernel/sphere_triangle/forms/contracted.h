// A number type in which x y + z is fused wherever a contracting compiler could fuse it, which -ffp-contract=off
// prevents. Tests use it to plant that fault.
#pragma once

#include <cmath>

#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/kernel.h"

namespace axiscert {

// A value, or a product that is not rounded yet: an addition to it fuses the two.
template <class Real>
struct ContractedNumber {
  Real value = 0, factor = 1;

  Real rounded() const { return value * factor; }
  friend ContractedNumber operator*(ContractedNumber a, ContractedNumber b) { return {a.rounded(), b.rounded()}; }
  friend ContractedNumber operator+(ContractedNumber a, ContractedNumber b) {
    return {std::fma(b.value, b.factor, a.rounded())};
  }
  friend ContractedNumber operator-(ContractedNumber a, ContractedNumber b) {
    return {std::fma(-b.value, b.factor, a.rounded())};
  }
};

// The published sides of a query as a contracted build computes them.
template <class Real>
Sides<Real> contracted_sides(const Query<Real>& q) {
  const auto fused = sides_of<portable::PublishedFormulae>(
      problem_as<ContractedNumber<Real>>(q, [](Real x) { return ContractedNumber<Real>{x}; }));
  Sides<Real> sides;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    sides.lhs[k] = fused.lhs[k].rounded();
    sides.rhs[k] = fused.rhs[k].rounded();
  }
  return sides;
}

// contracted_sides as a kernel's `explain`, with strict sides.
template <class Real>
void contracted_explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    std::array<Real, coordinate_count> v;
    for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = batch.column[k][i];
    const Sides<Real> sides = contracted_sides(from_coordinates(v));
    for (std::size_t k = 0; k < comparison_count; ++k) {
      out.lhs[k][i] = sides.lhs[k];
      out.rhs[k][i] = sides.rhs[k];
    }
    out.bits[i] = bits_of(sides, Strictness::strict);
  }
}

}  // namespace axiscert
