// A stored query as one of sphere-triangle, for code that serves this predicate alone.
#pragma once

#include <fmt/format.h>

#include <variant>

#include "fuzz/files/query_file.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

using SphereTriangleQuery = std::variant<Query<float>, Query<double>>;

// Throws Error that names the query and its predicate where it is of another one.
inline SphereTriangleQuery sphere_triangle_query(const StoredQuery& stored) {
  const Predicate& served = sphere_triangle_predicate();
  if (stored.predicate != &served) {
    throw Error(fmt::format("{}: a query of the predicate {}; only queries of {} are served here", shown(stored.id),
                            stored.predicate->id, served.id));
  }
  return std::visit([](const auto& numbers) -> SphereTriangleQuery { return query_from(numbers); }, stored.numbers);
}

// The same where the caller knows the precision. Precondition: it is that of the query.
template <class Real>
Query<Real> sphere_triangle_query_in(const StoredQuery& stored) {
  return std::get<Query<Real>>(sphere_triangle_query(stored));
}

}  // namespace axiscert
