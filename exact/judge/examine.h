// Everything about one query and one kernel: what `check` prints and what a witness is made of.
#pragma once

#include <tuple>

#include "exact/judge/claim.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/measures/error_measure.h"
#include "kernel/kernel.h"

namespace axiscert {

struct Examination {
  ExactTruth truth;
  std::optional<Rational> squared_distance;  // exact; none where the truth is `invalid`
  Answer answer;
  std::optional<Sides<double>> sides;  // those computed, where the kernel shows them: a binary64 holds either precision
  Judgement judgement;
  std::optional<double> depth;    // of a wrong verdict
  bool within_limits = true;      // those that the kernel declares; also where the truth is `invalid`
  std::vector<Finding> findings;  // what the kernel did wrong beside
};

// Examines queries by all oracles. In each precision the kernel is begun once, since somebody else's code is a process;
// and again after a query that it did not answer.
class Examiner {
 public:
  // Both have to outlive it.
  Examiner(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}
  const Kernel& kernel() const { return kernel_; }

  // The kernel exists in this precision. Throws OracleDisagreement.
  template <class Real>
  Examination examine(const Query<Real>& q);

 private:
  const Kernel& kernel_;
  std::string_view target_;
  std::tuple<std::optional<Implementation<float>>, std::optional<Implementation<double>>> begun_;
};

// With the answer that a kernel gave earlier.
template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, const Answer& answer);

}  // namespace axiscert
