// What a test is, as data: for all that handles answers and is written once for every test.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/names.h"

namespace axiscert {

// What a column holds, and so what may be done to it: a direction is not moved by a translation, a length not negative.
enum class Role : std::uint8_t { coordinate, direction, length, time };
inline constexpr std::array<std::string_view, 4> role_names = {"coordinate", "direction", "length", "time"};
constexpr std::string_view name(Role role) { return role_names[static_cast<std::size_t>(role)]; }

struct TestColumn {
  std::string_view name;
  Role role;
  std::string_view group;  // columns of one group are one thing: the three of a vertex
};

// One of the ways in which the numbers of a query can be given.
struct TestEntry {
  std::string_view name;
  std::string_view validity;  // which numbers are a query; any others are `invalid`
  std::vector<TestColumn> columns;
};

struct TestComparison {
  std::string_view name;
  std::size_t clause;
};

// The general word for what is an axis in a test by separating axes.
struct TestClause {
  std::string_view name;
  std::uint64_t comparisons;  // it holds where all of these do; bit i is comparison i
};

// A number beside the verdict: a time of impact.
struct TestMeasure {
  std::string_view name, unit;
  std::string_view error;  // how its error is counted
};

// What it is called where a kernel says one verdict and another is right.
struct WrongAnswer {
  Verdict said, right;
  std::string_view name;
};

// How the clauses make the verdict.
struct VerdictRule {
  std::string_view text;
  // Of comparison bits, whether they separate; null: wherever a clause holds.
  bool (*separates)(std::uint64_t comparisons) = nullptr;
};
inline constexpr VerdictRule any_clause_separates = {"separated where any clause holds"};

// Of each, as bits and the plug-in interface count them.
inline constexpr std::size_t most_columns = 64, most_comparisons = 64, most_measures = 64;

struct TestDescription {
  std::string_view id;
  std::string_view asks;      // one line
  std::string_view touching;  // what that is here
  std::vector<WrongAnswer> wrong_answers;
  std::vector<TestEntry> entries;  // the first is what a kernel takes that names none
  std::vector<TestComparison> comparisons;
  std::vector<TestClause> clauses;
  std::vector<TestMeasure> measures;
  VerdictRule rule = any_clause_separates;
};

// The description as it is given. Throws HarnessFault where it has no entry, more than the most of anything, a name
// twice, or a comparison whose clause is not there or does not need it.
TestDescription checked(TestDescription test);

// Bit i is clause i.
std::uint64_t clauses_of(const TestDescription& test, std::uint64_t comparisons);
Verdict verdict_of(const TestDescription& test, std::uint64_t comparisons);

// The index of an entry; an empty name means the first. Throws Error naming those that exist, the most alike first.
std::size_t find_entry(const TestDescription& test, std::string_view name);

// The tests that exist; defined in kernel/registry/tests.cpp. find_test throws Error as find_entry does.
std::span<const TestDescription* const> tests();
const TestDescription& find_test(std::string_view id);
// The test of a kernel that names none.
const TestDescription& first_test();

}  // namespace axiscert
