// The full examination of one query with one kernel by the oracles of its predicate: the output of `check` and the
// content of a witness.
#pragma once

#include <optional>
#include <tuple>

#include "exact/judge/oracles.h"

namespace axiscert {

// The sides that a kernel shows, by comparison; a binary64 holds either precision.
struct ShownSides {
  std::vector<double> lhs, rhs;
};

struct Examination {
  Truth truth;
  Answer answer;
  // The signs of the formulae that the predicate publishes or, where it publishes none, of the kernel's claim; and the
  // exact squared distance, in a predicate that compares one. Empty for an invalid query.
  std::optional<ExactSigns> exact;
  std::optional<Rational> squared_distance;
  Judgement judgement;
  std::optional<double> depth;      // of the query, if the verdict is wrong and the predicate has a depth
  std::optional<double> length;     // the same as a length in the query's unit
  std::optional<ShownSides> sides;  // as computed, if the kernel exposes them and was asked now
  std::vector<double> measures;     // that the kernel gave, the first of the predicate's
  // The judgement of these: of motions beside a right contact, or of a missed one; else beside any verdict.
  std::optional<ContactJudgement> contact;
  bool is_promised = true;        // the query is one on which the kernel promises to be right, or is invalid
  std::vector<Finding> findings;  // faults of the kernel other than a wrong answer
};

// Examines queries of the kernel's predicate. The kernel is begun once in each precision, since a plug-in is a process
// of its own, and again after a query that it did not answer.
class Examiner {
 public:
  // The kernel and the string must outlive the examiner.
  Examiner(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}
  const Kernel& kernel() const { return kernel_; }

  // Precondition: the kernel exists in this precision. Throws OracleDisagreement.
  Examination examine(const Numbers<float>& q) { return examine_as(q); }
  Examination examine(const Numbers<double>& q) { return examine_as(q); }

 private:
  template <class Real>
  Examination examine_as(const Numbers<Real>& q);

  const Kernel& kernel_;
  std::string_view target_;
  std::tuple<std::optional<Implementation<float>>, std::optional<Implementation<double>>> begun_;
};

// Examines an answer that a kernel gave earlier, and the measures that it gave with it.
Examination examine(const Numbers<float>& q, const Kernel& kernel, const Answer& answer,
                    std::vector<double> measures = {});
Examination examine(const Numbers<double>& q, const Kernel& kernel, const Answer& answer,
                    std::vector<double> measures = {});

}  // namespace axiscert
