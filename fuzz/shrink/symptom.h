// What is wrong with a kernel on one query, and how badly: what a smaller query has to go on showing.
#pragma once

#include <variant>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/judge/examine.h"
#include "kernel/ask.h"

namespace axiscert {

// A flip; or, where `kind` is empty, the error of a comparison, whatever its sign.
struct Symptom {
  Level level = Level::verdict;
  std::uint8_t index = 0;  // of the axis or comparison
  std::optional<FlipKind> kind = {};
  bool decisive = false;
  LinkBits links = 0;
  // Of a wrong verdict the decisive comparison flips, of an axis its comparison flips: some of these have to be left,
  // if there are any, and no others come in.
  ComparisonBits causes = 0;
};
std::string_view name(const Symptom& symptom);  // "verdict", "edge_ab", "edge_ab.radius"
// "verdict false_separation [rounding]", "edge_ab.radius error".
std::string text(const Symptom& symptom);

// Exact, and free of units:
//   of a wrong verdict, its depth;
//   of a comparison's flip, |lhs - rhs| / (|lhs| + |rhs|) of the exact sides, 0 where both are 0; where lhs is a root,
//     of the sides' squares with their signs, which orders queries in the same way;
//   of an axis, that of the comparison that decides: the least one where all of them hold, else the farthest from it;
//   of a comparison's error, that error in u; where a side is a root, rounded up to six digits.
struct Severity {
  std::variant<ExactDepth, Rational, Decimal6> exact;
  std::string text;  // "0.68 of the scene", "relative margin 1.2e-05", "961.012 u"
};
// Certain: two rounded errors that are equal do not tell, and are not.
bool is_no_less(const Severity& now, const Severity& then);

// Asks one kernel about queries, by CGAL and the exact formulae. Somebody else's code is a process that is begun once,
// and again after a query that it did not answer.
template <class Real>
class Diagnosis {
 public:
  // Both have to outlive it. The kernel exists in this precision.
  Diagnosis(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}

  // Every flip, in the order verdict, axes, comparisons. Throws OracleDisagreement.
  std::vector<Symptom> flips(const Query<Real>& q);
  // Nothing where the query does not show the symptom, or shows it only outside the limits that the kernel declares.
  std::optional<Severity> severity(const Query<Real>& q, const Symptom& symptom);

 private:
  Reply<Real> asked(const Query<Real>& q);

  const Kernel& kernel_;
  std::string_view target_;
  std::optional<Implementation<Real>> implementation_;
};

}  // namespace axiscert
