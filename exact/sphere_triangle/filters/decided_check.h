// The sample that detects faults of the filters: their decisions compared with exact arithmetic.
#pragma once

#include "exact/sphere_triangle/filters/cascade.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {

// One in this many of the queries that integers of any size decide is decided by CGAL as well: these queries are few,
// and the hardest.
inline constexpr std::uint64_t integer_check_stride = 64;

// `truth` is that of a valid query. Throws OracleDisagreement if the signs, or the conclusions drawn from them, differ.
template <class Real>
void require_same(const DecidedSigns& decided, const ExactTruth& truth, const Query<Real>& q);

}  // namespace axiscert
