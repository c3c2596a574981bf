// A smaller query on which a kernel is wrong in the same way and no less severely.
#pragma once

#include <functional>

#include "fuzz/shrink/query_size.h"
#include "fuzz/shrink/symptom.h"

namespace axiscert {

template <class Real>
struct Shrunk {
  Query<Real> query;
  Severity before, after;
  std::vector<QuerySize> sizes;   // size of the given query, then after each accepted step: strictly decreasing
  std::uint64_t evaluations = 0;  // smaller queries that the kernel was asked about
  bool complete = true;           // no step makes it smaller; otherwise the limit was reached
};

// Tries all ways to change one thing (fuzz/shrink/shrink_moves.h) and accepts each that makes the query smaller by
// QuerySize and keeps the symptom with a severity not below that of the given query; ends after a round in which none
// does. It always ends, since sizes cannot decrease for ever; `limit` bounds the time. Throws Error if the given query
// does not show the symptom; HarnessFault if the oracles contradict their earlier answer.
// `evaluated`, if there is one, is told the number of evaluations so far after each.
template <class Real>
Shrunk<Real> shrink(const Query<Real>& q, const Symptom& symptom, const Kernel& kernel, std::string_view target,
                    std::uint64_t limit, const std::function<void(std::uint64_t)>& evaluated = {});

}  // namespace axiscert
