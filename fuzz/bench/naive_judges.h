// The programs of a user who needs the truth of many queries and has no axiscert. The benchmark of truth is compared
// with them.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/sphere_triangle/oracles/signs.h"
#include "kernel/sphere_triangle/forms/evaluate.h"

namespace axiscert {

// The number of valid queries that are separated, by CGAL's exact distance: points and triangle are constructed for
// each query, `squared_distance(p, t) > r * r`. The kernel is the one that CGAL recommends where constructions have to
// be exact.
template <class Real>
std::uint64_t separated_by_distance(const std::vector<Query<Real>>& queries);

// Evaluates the sixteen comparisons of the published formulae for each valid query over CGAL's intervals; a query with
// a sign that these leave open is decided in exact arithmetic. `out` is resized to the queries. Returns the number of
// queries left open.
template <class Real>
std::uint64_t signs_by_intervals(const std::vector<Query<Real>>& queries, std::vector<Signs>& out);

// The number of valid queries that are contacts, by CGAL's predicate compare_squared_distance_3 in the kernel that is
// exact for predicates only.
template <class Real>
std::uint64_t contacts_by_epick(const std::vector<Query<Real>>& queries);

}  // namespace axiscert
