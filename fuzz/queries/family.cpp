// The families of all tests, in the order of the tests.
#include "fuzz/queries/family.h"

#include <vector>

#include "fuzz/queries/entry_families.h"
#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "kernel/test_list.h"

namespace axiscert {

#define AXISCERT_DECLARE(name) std::span<const Family* const> name##_families();
AXISCERT_TESTS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

std::span<const Family* const> families() {
  static const std::vector<const Family*> all = [] {
    std::vector<const Family*> families;
    const auto append = [&](std::span<const Family* const> more) {
      families.insert(families.end(), more.begin(), more.end());
    };
#define AXISCERT_APPEND(name) append(name##_families());
    AXISCERT_TESTS(AXISCERT_APPEND)
#undef AXISCERT_APPEND
    return families;
  }();
  return all;
}

std::vector<const Family*> families_of(const TestDescription& test) {
  std::vector<const Family*> all;
  for (const Family* family : families()) {
    if (&family->test() == &test) all.push_back(family);
  }
  return all;
}

std::vector<const Family*> families_of(const TestDescription& test, std::size_t entry) {
  std::vector<const Family*> all = families_of(test);
  std::erase_if(all, [&](const Family* family) { return family->entry != entry; });
  return all;
}

const Family& find_family(std::string_view name) {
  std::vector<std::string_view> known;
  for (const Family* family : families()) {
    if (family->name == name) return *family;
    known.push_back(family->name);
  }
  throw Error(unknown_name("family", "families", name, known));
}

}  // namespace axiscert
