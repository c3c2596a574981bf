// The estimates that guide a search: of every query of a batch, how much it shows of what is looked for.
#pragma once

#include "fuzz/search/goal.h"
#include "kernel/ask.h"

namespace axiscert {

// Estimates by about twice the precision that the kernel has, not by exact arithmetic: they choose which queries are
// kept, and what is reported of those is computed again, exactly. The same on every machine: sums, products, quotients
// and roots alone. Borrows the kernel.
template <class Real>
class Evaluator {
 public:
  Evaluator(const Kernel& kernel, std::string_view target);

  // Writes the score of each query, not negative; 0 where there is nothing. For the goals about verdicts it solves each
  // query's radius.
  void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores);

  // What vanishes where a comparison loses its scale, in binary64: l of a radius comparison, l - r of a side
  // comparison. Guides Newton's steps.
  double vanishing(Comparison which, const Query<Real>& q) const;

 private:
  void evaluate_error(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores);
  void evaluate_range(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores);
  void evaluate_radius(Goal goal, QueryBatch<Real>& batch, std::vector<double>& scores);

  const Kernel& kernel_;
  Implementation<Real> implementation_;
  Implementation<double> wide_;  // of the formulae, for binary32; empty where there is none in lanes
  Reply<Real> reply_;
  QueryBatch<double> widened_{0};
  Answers<double> wide_answers_;
};

}  // namespace axiscert
