// The proved bounds of the errors that a search maximises.
#pragma once

#include <optional>

#include "exact/numbers/decimal6.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/kernel.h"

namespace axiscert {

// The bounds that a predicate has for kernels that claim to give the recorded programs' bits.
class ProvedBounds {
 public:
  virtual ~ProvedBounds() = default;
  // A bound on Goal::error of a kernel's comparison, in u, that a checker accepted (docs/bounds.md); empty as long as
  // it is open. Every attained error has to be at most that: a greater one would refute the proof or its
  // interpretation.
  virtual std::optional<Decimal6> error(const Kernel& kernel, Precision precision, std::size_t comparison) const = 0;
  // Whether the bounds hold on a valid query.
  virtual bool cover(const Numbers<float>& q) const = 0;
  virtual bool cover(const Numbers<double>& q) const = 0;
  // Whether the kernel showed the sides that it claims to compute: those of foreign code may be others, which no bound
  // is for. The query is number `i` of the batch that was answered.
  virtual bool are_as_claimed(const Kernel& kernel, const Numbers<float>& q, const Answers<float>& answers,
                              std::size_t i) const = 0;
  virtual bool are_as_claimed(const Kernel& kernel, const Numbers<double>& q, const Answers<double>& answers,
                              std::size_t i) const = 0;
};

// ProvedBounds::error; empty where the kernel's predicate has no bounds.
inline std::optional<Decimal6> proved_error(const Kernel& kernel, Precision precision, std::size_t comparison) {
  const ProvedBounds* bounds = capabilities_of(*kernel.predicate).proved_bounds;
  return bounds ? bounds->error(kernel, precision, comparison) : std::nullopt;
}

}  // namespace axiscert
