#include "reports/certificate/findings/test_words.h"

#include <fmt/format.h>

#include "kernel/base/error.h"
#include "kernel/test_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name)          \
  const TestDescription& name##_test(); \
  const TestWords& name##_words();
AXISCERT_TESTS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const TestWords& test_words_of(const TestDescription& test) {
#define AXISCERT_FIND(name) \
  if (&test == &name##_test()) return name##_words();
  AXISCERT_TESTS(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the test '{}' is not on the list of kernel/test_list.h", test.id));
}

}  // namespace axiscert
