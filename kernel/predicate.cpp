#include "kernel/predicate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

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
void require_at_most(std::string_view predicate, std::string_view what, const std::vector<NamedValue>& all,
                     std::size_t most) {
  if (all.size() > most) {
    throw HarnessFault(fmt::format("predicate '{}' has {} {}; at most {}", predicate, all.size(), what, most));
  }
  std::set<std::string_view> seen;
  for (const std::string_view name : names_of(all)) {
    if (name.empty()) throw HarnessFault(fmt::format("predicate '{}': one of its {} has no name", predicate, what));
    if (!seen.insert(name).second) {
      throw HarnessFault(fmt::format("predicate '{}' has '{}' twice among its {}", predicate, name, what));
    }
  }
}

}  // namespace

std::vector<ColumnGroup> groups_of(const PredicateEntry& entry) {
  std::vector<ColumnGroup> groups;
  for (std::size_t k = 0; k < entry.columns.size(); ++k) {
    if (groups.empty() || groups.back().name != entry.columns[k].group) {
      groups.push_back({entry.columns[k].group, k, 0});
    }
    ++groups.back().size;
  }
  return groups;
}

std::optional<std::size_t> first_measure(const Predicate& predicate, MeasureKind kind) {
  for (std::size_t k = 0; k < predicate.measures.size(); ++k) {
    if (predicate.measures[k].kind == kind) return k;
  }
  return std::nullopt;
}

bool gives_measure(const Predicate& predicate, std::size_t count, MeasureKind kind) {
  bool is_there = false;
  for (std::size_t k = 0; k < predicate.measures.size(); ++k) {
    if (predicate.measures[k].kind != kind) continue;
    if (k >= count) return false;
    is_there = true;
  }
  return is_there;
}

Predicate checked(Predicate predicate) {
  if (predicate.entries.empty())
    throw HarnessFault(fmt::format("predicate '{}' has no entry; at least one", predicate.id));
  require_at_most(predicate.id, "entries", predicate.entries, predicate.entries.size());
  for (const PredicateEntry& entry : predicate.entries) {
    require_at_most(predicate.id, fmt::format("columns of entry '{}'", entry.name), entry.columns, most_columns);
    require_at_most(predicate.id, fmt::format("groups of entry '{}'", entry.name), groups_of(entry), most_columns);
  }
  require_at_most(predicate.id, "comparisons", predicate.comparisons, most_comparisons);
  require_at_most(predicate.id, "clauses", predicate.clauses, most_comparisons);
  require_at_most(predicate.id, "measures", predicate.measures, most_measures);
  for (std::size_t i = 0; i < predicate.comparisons.size(); ++i) {
    const auto& [name, clause, ties_at_touching] = predicate.comparisons[i];
    if (clause < predicate.clauses.size() && has_bit(predicate.clauses[clause].comparisons, i)) continue;
    throw HarnessFault(fmt::format("predicate '{}': comparison '{}' is of clause {}, which {}", predicate.id, name,
                                   clause,
                                   clause < predicate.clauses.size() ? "does not need it" : "it does not have"));
  }
  return predicate;
}

ComparisonBits all_comparisons(const Predicate& predicate) {
  const std::size_t count = predicate.comparisons.size();
  return count == 0 ? 0 : ~ComparisonBits{0} >> (most_comparisons - count);
}

ClauseBits clauses_of(const Predicate& predicate, ComparisonBits comparisons) {
  ClauseBits clauses = 0;
  for (std::size_t i = 0; i < predicate.clauses.size(); ++i) {
    const ComparisonBits needed = predicate.clauses[i].comparisons;
    if ((comparisons & needed) == needed) clauses |= one_bit<ClauseBits>(i);
  }
  return clauses;
}

Verdict verdict_of(const Predicate& predicate, ComparisonBits comparisons) {
  const bool separates =
      predicate.rule.separates ? predicate.rule.separates(comparisons) : clauses_of(predicate, comparisons) != 0;
  return separates ? Verdict::separated : Verdict::contact;
}

std::size_t find_entry(const Predicate& predicate, std::string_view name) {
  const std::vector<std::string_view> known = names_of(predicate.entries);
  if (name.empty()) return 0;
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  throw Error(fmt::format("predicate '{}': {}", predicate.id, unknown_name("entry", "entries", name, known)));
}

}  // namespace axiscert
