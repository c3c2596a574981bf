// The full examination of one query with one kernel: the output of `check` and the content of a witness.
#pragma once

#include <tuple>

#include "exact/sphere_triangle/claims/claim.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/measures/error_measure.h"
#include "kernel/kernel.h"

namespace axiscert {

struct Examination {
  ExactTruth truth;
  std::optional<Rational> squared_distance;  // exact; empty if the truth is `invalid`
  Answer answer;
  std::optional<Sides<double>> sides;  // as computed, if the kernel exposes them; a binary64 holds either precision
  Judgement judgement;
  std::optional<double> depth;    // depth of the query, if the verdict is wrong
  bool within_limits = true;      // within the limits that the kernel declares; also true if the truth is `invalid`
  std::vector<Finding> findings;  // faults of the kernel other than a wrong answer
};

// Examines queries by all oracles. The kernel is begun once in each precision, since a plug-in is a process of its own,
// and again after a query that it did not answer.
class Examiner {
 public:
  // The kernel and the string must outlive the examiner.
  Examiner(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}
  const Kernel& kernel() const { return kernel_; }

  // Precondition: the kernel exists in this precision. Throws OracleDisagreement.
  template <class Real>
  Examination examine(const Query<Real>& q);

 private:
  const Kernel& kernel_;
  std::string_view target_;
  std::tuple<std::optional<Implementation<float>>, std::optional<Implementation<double>>> begun_;
};

// Examines an answer that a kernel gave earlier.
template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, const Answer& answer);

}  // namespace axiscert
