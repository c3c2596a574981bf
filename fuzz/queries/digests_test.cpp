// Compares the bytes that families make with the committed digests, which are those of every compiler and machine.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/digest.h"
#include "kernel/sources_testing.h"

namespace axiscert {
// Fails where the lines of the predicate's families in the file, a path in the repository, are not those of
// digest_lines(); each failure says how the file is written. Lines of other predicates that exist may stand between
// them.
inline void expect_committed_digests(const Predicate& predicate, const std::string& path) {
  std::ifstream file(SOURCE_FOLDER "/" + path);
  ASSERT_TRUE(file) << path << ": cannot be read, and has to hold the digests of the families of " << predicate.id;
  std::vector<std::string> committed;
  const auto name_in = [](std::string_view line) { return line.substr(0, line.find(' ')); };
  const auto is_of = [&](std::span<const Family* const> some, std::string_view line) {
    return std::any_of(some.begin(), some.end(), [&](const Family* f) { return f->name == name_in(line); });
  };
  for (std::string line; std::getline(file, line);) {
    const bool is_known = is_of(families(), line);
    EXPECT_TRUE(is_known) << path << ": a line of no family: " << line;
    if (is_of(all_families_of(predicate), line)) committed.push_back(line);
  }
  const std::vector<std::string> made = digest_lines(predicate);
  const std::string command = fmt::format("build/release/write_digests {} > {}", predicate.id, path);
  for (const std::string& line : made) {
    if (std::count(committed.begin(), committed.end(), line) == 1) continue;
    const std::string name(name_in(line));
    const bool is_new = std::none_of(committed.begin(), committed.end(),
                                     [&](const std::string& other) { return name_in(other) == name; });
    ADD_FAILURE() << path
                  << (is_new ? " has no line of '" + name + "'; it would be\n"
                             : ": '" + name +
                                   "' makes other queries at this version. Raise the version where that is meant; "
                                   "where not, this compiler or machine computes differently. Now\n")
                  << line << "\nwrite it anew: " << command;
  }
  if (testing::Test::HasFailure()) return;
  EXPECT_EQ(committed, made) << path << ": other order than the list of the families; write it anew: " << command;
}

// Every family makes the same bytes everywhere: in the preset release-clang too, since operands of which each draws a
// random number are evaluated in the order that a compiler likes.

// Tests are listed with it; without it, with a pointer.
static void PrintTo(const Predicate* predicate, std::ostream* out) { *out << predicate->id; }

namespace {

std::string name_in_sources(const Predicate& predicate) {
  std::string name(predicate.id);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class CommittedBytes : public testing::TestWithParam<const Predicate*> {};

// Each predicate's digests.txt is beside the list of its families, in a room that it may share with others.
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
