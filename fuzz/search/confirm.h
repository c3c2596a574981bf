// Exact evaluation, by all oracles, of a query that a search found: nothing is reported before that.
#pragma once

#include <optional>

#include "exact/judge/examine.h"
#include "exact/numbers/rational.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/search/method.h"
#include "kernel/kernel.h"

namespace axiscert {
// The errors of the computed sides on one query, by comparison, absolute and relative, both in u. Empty if a side is
// not finite or the exact sides are undefined; a relative error is also empty if |l| + |r| = 0 and l^ - r^ is not 0.
struct SideErrors {
  std::vector<std::optional<Decimal6>> absolute, relative;

  explicit SideErrors(std::size_t comparisons) : absolute(comparisons), relative(comparisons) {}
};

// Those of a kernel, whose implementation is asked. Empty if the kernel exposes no computed sides of formulae of its
// own, or the query is not valid. Throws OracleDisagreement.
template <class Real>
std::optional<SideErrors> side_errors(const Kernel&, const Implementation<Real>&, const Numbers<Real>&);

// The exact values of the aims that only some predicates have: all but wrong verdicts. The implementation is the
// kernel's, and may be asked.
class AimValues {
 public:
  // As Confirmer::value() says.
  virtual std::optional<Decimal6> value(const Aim&, const Kernel&, const Implementation<float>&,
                                        const Numbers<float>&) const = 0;
  virtual std::optional<Decimal6> value(const Aim&, const Kernel&, const Implementation<double>&,
                                        const Numbers<double>&) const = 0;

 protected:
  ~AimValues() = default;
};

// Asks one kernel. Keeps a reference to it.
template <class Real>
class Confirmer {
 public:
  Confirmer(const Kernel& kernel, std::string_view target)
      : kernel_(kernel), implementation_(kernel.on<Real>(target)), examiner_(kernel, target) {}

  // The value of the aim on a query, rounded up to six digits: an error in u, a depth, ulps; for range, range_score().
  // Empty if the query shows none: not within the box of Goal::error, a side without scale or not finite, no wrong
  // verdict of that kind, a change of range that also occurs with unbounded exponents; and if the predicate has no such
  // aim. Throws OracleDisagreement.
  std::optional<Decimal6> value(const Aim& aim, const Numbers<Real>& q);

  std::optional<SideErrors> errors(const Numbers<Real>& q) { return side_errors(kernel_, implementation_, q); }

  // The full examination of a query.
  Examination examine(const Numbers<Real>& q) { return examiner_.examine(q); }

 private:
  std::optional<Decimal6> depth(FlipKind wrong, const Numbers<Real>& q);

  const Kernel& kernel_;
  Implementation<Real> implementation_;
  Examiner examiner_;
};

// The proved bounds of the errors that a search maximises.

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
