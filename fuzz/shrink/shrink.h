// A smaller query on which a kernel is wrong in the same way and no less badly.
#pragma once

#include "fuzz/shrink/query_size.h"
#include "fuzz/shrink/symptom.h"

namespace axiscert {

template <class Real>
struct Shrunk {
  Query<Real> query;
  Severity before, after;
  std::vector<QuerySize> sizes;   // of the query given, then after each step that was taken: strictly decreasing
  std::uint64_t evaluations = 0;  // smaller queries that the kernel was asked about
  bool complete = true;           // no step makes it smaller; else the limit was reached
};

// Walks over all ways to change one thing (fuzz/shrink/shrink_moves.h), takes each that makes the query smaller by
// QuerySize and keeps the symptom, with a severity that is not below that of the query given, and ends after a round in
// which none did. It ends always, since no size can be made smaller for ever; `limit` bounds the time that it takes.
// Throws Error where the query given does not show the symptom; HarnessFault where the oracles take back what they
// said.
template <class Real>
Shrunk<Real> shrink(const Query<Real>& q, const Symptom& symptom, const Kernel& kernel, std::string_view target,
                    std::uint64_t limit);

}  // namespace axiscert
