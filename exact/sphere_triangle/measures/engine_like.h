// Queries such as an engine asks.
#pragma once

#include <cstdint>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// An engine-like query of sphere-triangle: every number is zero or normal, no |coordinate| is above 2^20, and the
// radius is from 2^-20 to 2^20: from a micrometre to a thousand kilometres where the unit is a metre. A wrong verdict
// on one is counted where its depth is above 16 u; below, it is the rounding of the query's own numbers that decides.
template <class Real>
bool is_engine_like(const Query<Real>& q);
template <class Real>
std::uint64_t engine_like_queries(const QueryColumns<Real>& columns);
template <class Real>
inline constexpr double engine_depth = sizeof(Real) == 4 ? 0x1p-20 : 0x1p-49;  // 16 u

}  // namespace axiscert
