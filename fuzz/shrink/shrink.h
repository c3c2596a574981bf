// A smaller query on which a kernel is wrong in the same way and no less severely.
#pragma once

#include <functional>

#include "fuzz/shrink/symptom.h"
#include "fuzz/shrink/query_properties.h"

namespace axiscert {

template <class Real>
struct ShrinkResult {
  Numbers<Real> query;
  Severity before, after;
  Keep kept;                      // besides the symptom
  std::vector<QuerySize> sizes;   // size of the given query, then after each accepted step: strictly decreasing
  std::uint64_t evaluations = 0;  // smaller queries that the kernel was asked about
  bool complete = true;           // no step makes it smaller; otherwise the limit was reached
};

// The severity of what has to be kept, on a valid query; empty if the query does not show it.
template <class Real>
using SeverityOn = std::function<std::optional<Severity>(const Numbers<Real>&)>;

// Whether a smaller query keeps the class of the given one, and its depth within depth_factor (fuzz/shrink/symptom.h).
enum class KeepingRule : std::uint8_t { symptom_and_class, symptom };

// Told the number of evaluations so far at each; false ends it there, as the limit does.
using CountEvaluations = std::function<bool(std::uint64_t)>;

// Tries all ways to change one thing (fuzz/shrink/shrink_moves.h) and accepts each that makes the query smaller by
// QuerySize and keeps what has to be kept with a severity not below that of the given query; ends after a round in
// which none does. It always ends, since sizes cannot decrease for ever; `limit` bounds the time. Precondition: the
// given query, of this entry of `predicate`, shows it. Throws HarnessFault if the oracles contradict their earlier
// answer.
template <class Real>
ShrinkResult<Real> shrink(const Predicate& predicate, const Numbers<Real>& q, const SeverityOn<Real>& severity,
                          KeepingRule keeping, std::uint64_t limit, const CountEvaluations& evaluated = {},
                          std::size_t entry = 0);

// The same for a symptom of a kernel, of whose predicate the query is. Throws Error if the given query does not show
// it.
template <class Real>
ShrinkResult<Real> shrink(const Numbers<Real>& q, const Symptom& symptom, const Kernel& kernel, std::string_view target,
                          std::uint64_t limit, KeepingRule keeping = KeepingRule::symptom_and_class,
                          const CountEvaluations& evaluated = {});

}  // namespace axiscert
