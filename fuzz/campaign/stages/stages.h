// A batch of queries on its way through a unit.
#pragma once

#include <cstdint>

#include "kernel/query.h"

namespace axiscert {

// Queries as their source made them.
template <class Real>
struct MadeBatch {
  const QueryBatch<Real>& queries;
  std::uint64_t position;  // of the first one, in its source

  std::size_t size() const { return queries.size(); }
};

}  // namespace axiscert
