// One query with one kernel of any test, examined by the test's oracles: the content of a witness.
#pragma once

#include <optional>
#include <tuple>

#include "exact/trait/oracles.h"

namespace axiscert {

struct OracleExamination {
  Truth truth;
  Answer answer;
  std::optional<Claimed> claim;  // empty without formulae, and if the truth is `invalid`
  Judgement judgement;
  std::optional<double> depth;            // of the query, if the verdict is wrong and the test has a depth
  std::vector<double> measures;           // that the kernel gave, the first of the test's
  std::optional<MotionJudgement> motion;  // of these, beside a contact that is right
  std::optional<Tunnel> missed;           // of a missed contact, in a test with measures
  bool is_promised = true;                // the query is one on which the kernel promises to be right
  std::vector<Finding> findings;          // faults of the kernel other than a wrong answer
};

// Examines queries of the kernel's test. The kernel is begun once in each precision, and again after a query that it
// did not answer.
class OracleExaminer {
 public:
  // The kernel and the string must outlive the examiner.
  OracleExaminer(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}
  const Kernel& kernel() const { return kernel_; }

  // Precondition: the kernel exists in this precision. Throws OracleDisagreement.
  template <class Real>
  OracleExamination examine(const Numbers<Real>& q);

 private:
  const Kernel& kernel_;
  std::string_view target_;
  std::tuple<std::optional<Implementation<float>>, std::optional<Implementation<double>>> begun_;
};

// Examines an answer that a kernel gave earlier, and the measures that it gave with it.
template <class Real>
OracleExamination examine_by_oracles(const Numbers<Real>& q, const Kernel& kernel, const Answer& answer,
                                     std::vector<double> measures = {});

}  // namespace axiscert
