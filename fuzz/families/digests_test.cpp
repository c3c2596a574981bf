// Every family makes the same bytes everywhere. The quick sanitized build has this too, of the families that it
// compiles, since its compiler is another: operands of which each draws a random number are evaluated in the order that
// a compiler likes.
#include <algorithm>

#include "fuzz/families/digest_testing.h"
#include "kernel/testing/sources.h"

namespace axiscert {

// Tests are listed with it; without it, with a pointer.
static void PrintTo(const Predicate* predicate, std::ostream* out) { *out << predicate->id; }

namespace {

std::string name_in_sources(const Predicate& predicate) {
  std::string name(predicate.id);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class CommittedBytes : public testing::TestWithParam<const Predicate*> {};

// Each test's digests.txt is beside the list of its families, in the room that the test may share with others.
TEST_P(CommittedBytes, AreMadeByEveryFamily) {
  const auto lists = testing_support::defined_in("fuzz", R"((\w+)_families\(\) \{)");
  const std::string name = name_in_sources(*GetParam());
  ASSERT_TRUE(lists.contains(name)) << "no source in fuzz defines " << name << "_families()";
  const std::string& list = lists.at(name);
  expect_committed_digests(*GetParam(), list.substr(0, list.rfind('/')) + "/digests.txt");
}

INSTANTIATE_TEST_SUITE_P(Predicates, CommittedBytes, testing::ValuesIn(predicates().begin(), predicates().end()),
                         [](const auto& info) { return name_in_sources(*info.param); });

}  // namespace
}  // namespace axiscert
