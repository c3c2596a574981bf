// The queries of family `tie`, for families that are built from them.
#pragma once

#include <cstdint>

#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Integers that touch exactly, on the feature of axis `position` modulo axis_count; below 2^24 (2^53).
template <class Real>
Query<Real> touching_integers(Stream& random, std::uint64_t position);

}  // namespace axiscert
