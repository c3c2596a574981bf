// The fault of a kernel on one query, and its severity: a smaller query has to keep showing it.
#pragma once

#include <optional>
#include <variant>

#include "exact/judge/examine.h"
#include "exact/judge/oracles.h"
#include "fuzz/record/measure_fault.h"
#include "fuzz/shrink/query_properties.h"
#include "kernel/ask.h"

namespace axiscert {
// A flip; or, if `kind` is empty, the error of a comparison, whatever its sign; or, if `measure` is not, what is wrong
// with the numbers beside the verdict.
struct Symptom {
  const Predicate* predicate;
  Level level = Level::verdict;
  std::uint8_t index = 0;  // index of the axis or comparison
  std::optional<FlipKind> kind = {};
  bool decisive = false;
  LinkSet links = {};
  // For a wrong verdict the decisive comparison flips, for an axis its comparison flips: some of these have to remain,
  // if there are any, and no others may be added.
  ComparisonBits causes = 0;
  std::optional<MeasureFault> measure = {};
};
std::string_view name(const Symptom& symptom);  // "verdict", "edge_ab", "edge_ab.radius", "time"
// "verdict false_separation [rounding]", "edge_ab.radius error", "late time".
std::string text(const Symptom& symptom);

// A depth, rounded once to the nearest binary64.
struct RoundedDepth {
  double value;
};

// Exact, without a unit:
//   for a wrong verdict, its depth: where the oracles have it only rounded, so, and 0 where the predicate has none; for
//   a comparison's flip, |lhs - rhs| / (|lhs| + |rhs|) of the exact sides, 0 where both are 0; if lhs is a root, the
//   same with the signed squares of the sides, which orders queries in the same way; for an axis, the value of the
//   comparison that decides: the least one if all of them hold, otherwise that of the comparison farthest from holding;
//   for a comparison's error, that error in u; rounded up to six digits if a side is a root;
//   for a measure, its error.
struct Severity {
  std::variant<ExactDepth, RoundedDepth, Rational, Decimal6> exact;
  std::string text;  // "0.68 of the scene", "relative margin 1.2e-05", "961.012 u"
};
// Only if certain: two rounded errors that are equal are not decisive, so the result is false. Two rounded depths that
// are equal are no less: a scene at another scale has the same depth.
bool is_no_less(const Severity& now, const Severity& then);
Severity depth_severity(AskedQuery& asked);  // of a valid query

// Asks one kernel about queries of its predicate, by the predicate's oracles. A foreign kernel's process is begun once,
// and again after a query that it did not answer.
template <class Real>
class SymptomFinder {
 public:
  // The kernel and the string must outlive the finder. The kernel exists in this precision.
  SymptomFinder(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}

  // Every flip, in the order verdict, axes, comparisons. Throws OracleDisagreement.
  std::vector<Symptom> flips(const Numbers<Real>& q);
  // What is wrong with the numbers beside the verdict, the worst first.
  std::vector<Symptom> measure_faults(const Numbers<Real>& q);
  // Whether the answer has the number that a fault is of, and it was compared.
  bool is_compared(const Numbers<Real>& q, MeasureFault which);
  // The largest error of a comparison, in u; empty where the kernel shows none.
  std::optional<Symptom> largest_error(const Numbers<Real>& q);
  // Why there is no verdict on a valid query that could be wrong: it is beyond what the kernel promises, or the kernel
  // declined it, called it invalid or gave no answer; empty where it said contact or separated.
  std::optional<std::string> why_no_verdict(const Numbers<Real>& q);
  // Empty if the query does not show the symptom, or shows it only outside the limits that the kernel declares.
  std::optional<Severity> severity(const Numbers<Real>& q, const Symptom& symptom);

 private:
  Reply<Real> asked(const Numbers<Real>& q);
  Judgement judgement(const Numbers<Real>& q);
  // Empty where the kernel gives no measures, or none are judged.
  std::optional<ContactJudgement> contact(const Numbers<Real>& q);

  const Kernel& kernel_;
  std::string_view target_;
  std::optional<Implementation<Real>> implementation_;
};

// The properties that a smaller query keeps besides its symptom: the class of its input, and a depth that is not
// another fault's.

// A depth may grow to this many times that of the given query: a missed contact by an ulp does not become one by a
// fifth of the scene, which would be another fault.
inline constexpr int depth_factor = 4;

class Keep {
 public:
  // Keeps nothing besides the symptom: as small as it goes.
  Keep() = default;
  // Keeps the class of this valid query of the entry, which has this severity.
  template <class Real>
  Keep(const Predicate& predicate, const Numbers<Real>& q, const Severity& severity, std::size_t entry = 0);

  // Whether a smaller query has the same class and meets no definition of a class that the given one does not, and a
  // depth of at most depth_factor times the given one's. Only a depth is limited, not a margin or an error.
  template <class Real>
  bool allows(const Numbers<Real>& q, const Severity& severity) const;

  // The definitions of classes that the given query meets, the first of them its class; empty if nothing is kept.
  const std::optional<std::vector<std::string_view>>& classes() const { return classes_; }

 private:
  const Predicate* predicate_ = nullptr;
  std::size_t entry_ = 0;
  std::optional<std::vector<std::string_view>> classes_;
  std::optional<Severity> greatest_;
};

}  // namespace axiscert
