// A family that makes its queries one at a time, each from a stream of its own.
#pragma once

#include "fuzz/queries/family.h"
#include "fuzz/queries/random.h"

namespace axiscert {

// A Fill<Real> by one(random, position), which returns a predicate's query or its Numbers<Real>.
template <auto one, class Real>
void fill_one_by_one(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  for (std::size_t i = 0; i < out.size; ++i) {
    Stream random(name, first + i);
    out.set(i, one(random, first + i));
  }
}

}  // namespace axiscert
