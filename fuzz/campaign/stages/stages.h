// A batch on its way through a unit: made, then decided. Each type holds what its stage found out; a stage takes the
// type of the one before it, so that none can be left out. What a stage refers to belongs to the unit and lasts until
// the next batch.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/sphere_triangle/filters/cascade.h"

namespace axiscert {

// Queries as their source made them.
template <class Real>
struct MadeBatch {
  const QueryBatch<Real>& queries;
  std::uint64_t position;  // of the first one, in its source

  std::size_t size() const { return queries.size(); }
};

// How an error watch looks at a query.
enum class Attention : std::uint8_t {
  none,     // not looked at: no truth, or counted elsewhere
  counted,  // by the watch
  checked,  // counted elsewhere, exactly; what the filter says of it is kept for the cross-check
};

// The same queries, and for each of them how it is judged: by signs that a filter decided, or by exact arithmetic.
template <class Real>
struct DecidedBatch : MadeBatch<Real> {
  const std::vector<DecidedSigns>& signs;
  const std::vector<Attention>& attention;  // of the error watches

  // A filter decided query `i`, whether or not exact arithmetic judges it again.
  bool is_filtered(std::size_t i) const { return signs[i].step != Step::exact; }
  bool is_exact(std::size_t i) const { return attention[i] != Attention::counted; }
};

}  // namespace axiscert
