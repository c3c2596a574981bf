#include "kernel/test.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "kernel/base/alike.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class NamedValue>
std::vector<std::string_view> names_of(const std::vector<NamedValue>& all) {
  std::vector<std::string_view> names;
  for (const NamedValue& one : all) names.push_back(one.name);
  return names;
}

template <class NamedValue>
void require_at_most(std::string_view test, std::string_view what, const std::vector<NamedValue>& all,
                     std::size_t most) {
  if (all.size() > most) {
    throw HarnessFault(fmt::format("test '{}' has {} {}; at most {}", test, all.size(), what, most));
  }
  std::set<std::string_view> seen;
  for (const std::string_view name : names_of(all)) {
    if (name.empty()) throw HarnessFault(fmt::format("test '{}': one of its {} has no name", test, what));
    if (!seen.insert(name).second) {
      throw HarnessFault(fmt::format("test '{}' has '{}' twice among its {}", test, name, what));
    }
  }
}

}  // namespace

std::vector<ColumnGroup> groups_of(const TestEntry& entry) {
  std::vector<ColumnGroup> groups;
  for (std::size_t k = 0; k < entry.columns.size(); ++k) {
    if (groups.empty() || groups.back().name != entry.columns[k].group) {
      groups.push_back({entry.columns[k].group, k, 0});
    }
    ++groups.back().size;
  }
  return groups;
}

TestDescription checked(TestDescription test) {
  if (test.entries.empty()) throw HarnessFault(fmt::format("test '{}' has no entry; at least one", test.id));
  require_at_most(test.id, "entries", test.entries, test.entries.size());
  for (const TestEntry& entry : test.entries) {
    require_at_most(test.id, fmt::format("columns of entry '{}'", entry.name), entry.columns, most_columns);
    require_at_most(test.id, fmt::format("groups of entry '{}'", entry.name), groups_of(entry), most_columns);
  }
  require_at_most(test.id, "comparisons", test.comparisons, most_comparisons);
  require_at_most(test.id, "clauses", test.clauses, most_comparisons);
  require_at_most(test.id, "measures", test.measures, most_measures);
  for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
    const auto& [name, clause, ties_at_touching] = test.comparisons[i];
    if (clause < test.clauses.size() && has_bit(test.clauses[clause].comparisons, i)) continue;
    throw HarnessFault(fmt::format("test '{}': comparison '{}' is of clause {}, which {}", test.id, name, clause,
                                   clause < test.clauses.size() ? "does not need it" : "it does not have"));
  }
  return test;
}

ComparisonBits all_comparisons(const TestDescription& test) {
  const std::size_t count = test.comparisons.size();
  return count == 0 ? 0 : ~ComparisonBits{0} >> (most_comparisons - count);
}

ClauseBits clauses_of(const TestDescription& test, ComparisonBits comparisons) {
  ClauseBits clauses = 0;
  for (std::size_t i = 0; i < test.clauses.size(); ++i) {
    const ComparisonBits needed = test.clauses[i].comparisons;
    if ((comparisons & needed) == needed) clauses |= one_bit<ClauseBits>(i);
  }
  return clauses;
}

Verdict verdict_of(const TestDescription& test, ComparisonBits comparisons) {
  const bool separates = test.rule.separates ? test.rule.separates(comparisons) : clauses_of(test, comparisons) != 0;
  return separates ? Verdict::separated : Verdict::contact;
}

std::size_t find_entry(const TestDescription& test, std::string_view name) {
  const std::vector<std::string_view> known = names_of(test.entries);
  if (name.empty()) return 0;
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  throw Error(fmt::format("test '{}': {}", test.id, unknown_name("entry", "entries", name, known)));
}

}  // namespace axiscert
