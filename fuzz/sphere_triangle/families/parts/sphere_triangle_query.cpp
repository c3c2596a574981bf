#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"

#include <fmt/format.h>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

SphereTriangleQuery sphere_triangle_query(const StoredQuery& stored) {
  const Predicate& served = sphere_triangle_predicate();
  if (stored.predicate != &served) {
    throw Error(fmt::format("{}: a query of the predicate {}; only queries of {} are served here", shown(stored.id),
                            stored.predicate->id, served.id));
  }
  return std::visit([](const auto& numbers) -> SphereTriangleQuery { return query_from(numbers); }, stored.numbers);
}

}  // namespace axiscert
