// What a user writes who needs the truth of many queries and has no axiscert: what the benchmark of truth is held
// against.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/sphere_triangle/filters/signs.h"
#include "kernel/sphere_triangle/reference/evaluate.h"

namespace axiscert {

// How many of the valid queries are separated, by CGAL's exact distance: points and triangle anew for each query,
// `squared_distance(p, t) > r * r`. The kernel is the one that CGAL recommends where constructions have to be exact.
template <class Real>
std::uint64_t separated_by_distance(const std::vector<Query<Real>>& queries);

// The sixteen comparisons of the published formulae of each valid query over CGAL's intervals; a query of which these
// leave a sign open is decided in exact arithmetic. `out` is sized to the queries. Returns how many were left open.
template <class Real>
std::uint64_t signs_by_intervals(const std::vector<Query<Real>>& queries, std::vector<Signs>& out);

// How many of the valid queries are contacts, by CGAL's predicate compare_squared_distance_3 in the kernel that is
// exact for predicates alone.
template <class Real>
std::uint64_t contacts_by_epick(const std::vector<Query<Real>>& queries);

}  // namespace axiscert
