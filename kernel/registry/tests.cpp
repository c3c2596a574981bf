// The tests that exist, of the one list.
#include <algorithm>

#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "kernel/test.h"
#include "kernel/test_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name) const TestDescription& name##_test();
AXISCERT_TESTS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

namespace {

const std::vector<const TestDescription*>& all_tests() {
#define AXISCERT_POINT(name) &name##_test(),
  static const std::vector<const TestDescription*> all = {AXISCERT_TESTS(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

}  // namespace

std::span<const TestDescription* const> tests() { return all_tests(); }

const TestDescription& find_test(std::string_view id, std::span<const TestDescription* const> known) {
  std::vector<std::string_view> ids;
  for (const TestDescription* test : known) {
    if (test->id == id) return *test;
    ids.push_back(test->id);
  }
  throw Error(unknown_name("test", "tests", id, ids));
}

std::string_view written_name(const TestDescription& test) { return test.is_implied ? std::string_view() : test.id; }

const TestDescription& test_named(std::string_view written, std::span<const TestDescription* const> known) {
  const auto implied = std::find_if(known.begin(), known.end(), [](const auto* test) { return test->is_implied; });
  return written.empty() && implied != known.end() ? **implied : find_test(written, known);
}

std::string id_prefix(const TestDescription& test) {
  const std::string_view name = written_name(test);
  return name.empty() ? std::string() : std::string(name) + "/";
}

}  // namespace axiscert
