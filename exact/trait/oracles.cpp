#include "exact/trait/oracles.h"

#include <fmt/format.h>

#include "kernel/base/error.h"
#include "kernel/test_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name)          \
  const TestDescription& name##_test(); \
  const Oracles& name##_oracles(std::size_t entry);
AXISCERT_TESTS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

const Oracles& oracles_of(const TestDescription& test, std::size_t entry) {
#define AXISCERT_FIND(name) \
  if (&test == &name##_test()) return name##_oracles(entry);
  AXISCERT_TESTS(AXISCERT_FIND)
#undef AXISCERT_FIND
  throw HarnessFault(fmt::format("the test '{}' is not on the list of kernel/test_list.h", test.id));
}

std::unique_ptr<BatchOracle<float>> Oracles::batches(std::string_view, std::type_identity<float>) const {
  return std::make_unique<AskedOneByOne<float>>();
}
std::unique_ptr<BatchOracle<double>> Oracles::batches(std::string_view, std::type_identity<double>) const {
  return std::make_unique<AskedOneByOne<double>>();
}

}  // namespace axiscert
