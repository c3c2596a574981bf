// The estimates that guide a search of sphere-triangle: for every query of a batch, how much of the aim it shows.
#pragma once

#include "fuzz/search/method.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Estimates in about twice the kernel's precision, not in exact arithmetic: they decide which queries are kept, and the
// reported values of those are computed again, exactly. The same on every machine: only sums, products, quotients and
// roots. Keeps a reference to the kernel.
template <class Real>
class Evaluator final : public Guide<Real> {
 public:
  Evaluator(const Kernel& kernel, std::string_view target);

  void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                std::vector<Verdict>& said) override;
  // Into the box of Goal::error.
  void settle(Numbers<Real>& q) const override;
  // For a relative error now and then a step to where the comparison's scale vanishes.
  bool step(const Aim& aim, Dice& random, Numbers<Real>& q) const override;
  // The six orders of the vertices.
  std::vector<Numbers<Real>> images(const Numbers<Real>& q) const override;
  std::uint64_t judged() const override { return judged_; }

  // The quantity that vanishes where a comparison loses its scale, in binary64: l for a radius comparison, l - r for a
  // side comparison. Guides Newton's steps.
  double vanishing(std::size_t which, const Query<Real>& q) const;

 private:
  void evaluate_error(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores);
  void evaluate_range(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores);
  void evaluate_radius(Goal goal, QueryBatch<Real>& batch, std::vector<double>& scores);

  const Kernel& kernel_;
  Implementation<Real> implementation_;
  Implementation<double> wide_;  // the formulae in binary64, for binary32; empty if there is no lane form
  Reply<Real> reply_;
  QueryBatch<double> widened_{0, coordinate_count};
  Answers<double> wide_answers_;
  std::uint64_t judged_ = 0;  // queries with finite sides
};

}  // namespace axiscert
