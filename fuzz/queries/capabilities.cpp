#include "fuzz/queries/capabilities.h"

#include <fmt/format.h>

#include "kernel/base/error.h"
#include "kernel/test_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name)          \
  const TestDescription& name##_test(); \
  const Capabilities& name##_capabilities();
AXISCERT_TESTS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const Capabilities& capabilities_of(const TestDescription& test) {
#define AXISCERT_FIND(name) \
  if (&test == &name##_test()) return name##_capabilities();
  AXISCERT_TESTS(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the test '{}' is not on the list of kernel/test_list.h", test.id));
}

}  // namespace axiscert
