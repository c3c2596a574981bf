// A stored query as one of sphere-triangle, for code that serves this predicate alone.
#pragma once

#include <variant>

#include "fuzz/files/query_file.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

using SphereTriangleQuery = std::variant<Query<float>, Query<double>>;

// Throws Error that names the query and its predicate where it is of another one.
SphereTriangleQuery sphere_triangle_query(const StoredQuery& stored);

// The same where the caller knows the precision. Precondition: it is that of the query.
template <class Real>
Query<Real> sphere_triangle_query_in(const StoredQuery& stored) {
  return std::get<Query<Real>>(sphere_triangle_query(stored));
}

}  // namespace axiscert
