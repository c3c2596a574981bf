// The proved bounds of the errors that a search maximises.
#pragma once

#include <optional>

#include "exact/numbers/decimal6.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/proved_bounds.h"

namespace axiscert {

// A bound on Goal::error of a kernel's comparison, in u, that a checker accepted (docs/bounds.md); empty as long as it
// is open. Every attained error has to be at most that: a greater one would refute the proof or its interpretation.
// Both precisions have the same bound in u. It applies to kernels that claim to give the recorded programs' bits.
inline std::optional<Decimal6> proved_error(const Kernel& kernel, Precision /*precision*/, Comparison which) {
  const bool published = kernel.formulae == Formulae::published, reduced = kernel.formulae == Formulae::reduced;
  const bool plain = kernel.arithmetic == Arithmetic::plain, fma = kernel.arithmetic == Arithmetic::fma;
  if (!kernel.is_reference || !(published || reduced) || !(plain || fma)) return std::nullopt;
  const auto row = (reduced ? 2u : 0u) + (fma ? 1u : 0u);
  return round_up(Rational(proved_sixteenths[row][index_of(which)], 16));
}

}  // namespace axiscert
