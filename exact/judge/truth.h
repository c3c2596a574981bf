// The truth about one query, as far as the judge needs it, and the error that ends a run when two oracles differ.
#pragma once

#include <string>
#include <vector>

#include "kernel/base/error.h"
#include "kernel/query.h"
#include "kernel/predicate.h"

namespace axiscert {

struct Truth {
  Verdict verdict;  // separated, contact (touching included) or invalid
  bool touching;    // distance exactly r
};

// Two oracles differ, or one contradicts the theorem. Carries the query so that it can be saved (a float widens
// exactly): the numbers of this entry of `of`.
struct OracleDisagreement : HarnessFault {
  template <class Real>
  OracleDisagreement(const std::string& what, const Numbers<Real>& q, const Predicate& of, std::size_t of_entry = 0)
      : HarnessFault("the oracles disagree: " + what),
        predicate(&of),
        entry(of_entry),
        precision(precision_of<Real>),
        query(q.begin(), q.end()) {}
  const Predicate* predicate;
  std::size_t entry;
  Precision precision;
  std::vector<double> query;
};

}  // namespace axiscert
