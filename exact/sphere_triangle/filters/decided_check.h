// What the filters decided, held against exact arithmetic: the sample by which a fault of a filter is found.
#pragma once

#include "exact/sphere_triangle/filters/cascade.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {

// Every so many of the queries that integers of any size decide are decided by CGAL as well: few queries, and the
// hardest.
inline constexpr std::uint64_t integer_check_stride = 64;

// `truth` is that of a valid query. Throws OracleDisagreement where the signs differ, or what follows from them.
template <class Real>
void require_same(const DecidedSigns& decided, const ExactTruth& truth, const Query<Real>& q);

}  // namespace axiscert
