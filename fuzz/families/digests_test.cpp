// Every family makes the same bytes everywhere. The sanitized build of the quick tests has this too, since its compiler
// is another: operands of which each draws a random number are evaluated in the order that a compiler likes.
#include <algorithm>

#include "fuzz/families/digest_testing.h"
#include "kernel/testing/sources.h"

namespace axiscert {
namespace {

// Each test's digests.txt is beside the list of its families, in the room that the test may share with others.
TEST(Families, MakeTheCommittedBytes) {
  const auto lists = testing_support::defined_in("fuzz/families", R"((\w+)_families\(\) \{)");
  for (const TestDescription* test : tests()) {
    std::string name(test->id);
    std::replace(name.begin(), name.end(), '-', '_');
    ASSERT_TRUE(lists.contains(name)) << "no source in fuzz/families defines " << name << "_families()";
    const std::string& list = lists.at(name);
    expect_committed_digests(*test, list.substr(0, list.rfind('/')) + "/digests.txt");
  }
}

}  // namespace
}  // namespace axiscert
