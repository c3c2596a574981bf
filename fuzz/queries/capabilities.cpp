#include "fuzz/queries/capabilities.h"

#include <fmt/format.h>

#include "kernel/base/error.h"
#include "kernel/predicate_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name)         \
  const Predicate& name##_predicate(); \
  const Capabilities& name##_capabilities();
AXISCERT_PREDICATES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const Capabilities& capabilities_of(const Predicate& predicate) {
#define AXISCERT_FIND(name) \
  if (&predicate == &name##_predicate()) return name##_capabilities();
  AXISCERT_PREDICATES(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the predicate '{}' is not on the list of kernel/predicate_list.h", predicate.id));
}

}  // namespace axiscert
