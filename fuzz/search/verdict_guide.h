// The guide of a search in any predicate whose oracles have a depth: by the kernel's verdicts and the oracles alone.
#pragma once

#include <optional>
#include <string_view>

#include "exact/trait/oracles.h"
#include "fuzz/search/guide.h"
#include "kernel/ask.h"

namespace axiscert {

// A query scores the depth of its wrong verdict, as the oracles have it. Where the entry has a length, the first of
// them is set to where the kernel's verdict changes: to the least float that bisection finds in contact, or the one
// below it for a missed contact. So every query comes to where it is wrong, if it is for any length. Keeps a reference
// to the kernel.
template <class Real>
class VerdictGuide final : public Guide<Real> {
 public:
  VerdictGuide(const Kernel& kernel, std::string_view target);
  void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                std::vector<Verdict>& said) override;
  void settle(Numbers<Real>& q) const override;

 private:
  void solve_lengths(Goal goal, QueryBatch<Real>& batch);
  double score(Goal goal, const Numbers<Real>& q, Verdict said) const;

  const Kernel& kernel_;
  const Oracles& oracles_;
  Implementation<Real> implementation_;
  std::optional<std::size_t> length_;  // the column that is solved
};

}  // namespace axiscert
