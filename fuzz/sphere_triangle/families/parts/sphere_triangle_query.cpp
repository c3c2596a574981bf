#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"

#include <fmt/format.h>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {

SphereTriangleQuery sphere_triangle_query(const StoredQuery& stored) {
  const TestDescription& served = sphere_triangle_test();
  if (stored.test != &served) {
    throw Error(fmt::format("{}: a query of the test {}; only queries of {} are served here", shown(stored.id),
                            stored.test->id, served.id));
  }
  return std::visit([](const auto& numbers) -> SphereTriangleQuery { return query_from(numbers); }, stored.numbers);
}

}  // namespace axiscert
