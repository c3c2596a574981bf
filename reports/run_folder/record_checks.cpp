#include "reports/run_folder/record_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "fuzz/text/json_form.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

using Fault = std::optional<std::string>;
using Names = std::vector<std::string_view>;

bool has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class One>
Names names_of(const std::vector<One>& all) {
  Names names;
  for (const One& one : all) names.push_back(one.name);
  return names;
}

Names group_names(const PredicateEntry& entry) { return names_of(groups_of(entry)); }

bool is_of(const GroupNumbers& numbers, const ColumnGroup& group) { return numbers.numbers.size() == group.size; }
bool is_of(const std::optional<GroupNumbers>& numbers, const ColumnGroup& group) {
  return !numbers || is_of(*numbers, group);
}

template <class Numbers>
const PredicateEntry* entry_of_numbers(const Predicate& predicate, const NamedValues<Numbers>& numbers) {
  const auto fits = [&](const ColumnGroup& group) {
    const Numbers* found = numbers.find(group.name);
    return found != nullptr && is_of(*found, group);
  };
  // One entry's groups may be among another's: that with most is meant.
  const PredicateEntry* found = nullptr;
  std::size_t most = 0;
  for (const PredicateEntry& entry : predicate.entries) {
    const std::vector<ColumnGroup> groups = groups_of(entry);
    if (groups.size() <= most || !std::all_of(groups.begin(), groups.end(), fits)) continue;
    found = &entry;
    most = groups.size();
  }
  return found;
}

class NameCheck {
 public:
  explicit NameCheck(const Record& record)
      : record_(record),
        predicate_(predicate_of(record.plan)),
        clauses_(names_of(predicate_.clauses)),
        comparisons_(names_of(predicate_.comparisons)) {}

  Fault check() const {
    if (Fault fault = unknown("tolerance", "comparison", record_.plan.tolerance, comparisons_)) return fault;
    for (const KernelRecord& kernel : record_.kernels) {
      for (const auto& [family, result] : kernel.families) {
        const std::string where = fmt::format("kernel {} in {}, family {}", json_of(kernel.id).dump(),
                                              name(kernel.precision), json_of(family).dump());
        if (Fault fault = all_and_no_other(where, "axis", result.axes, clauses_)) return fault;
        if (Fault fault = all_and_no_other(where, "comparison", result.comparisons, comparisons_)) return fault;
      }
    }
    for (const FindingRecord& finding : record_.findings) {
      const std::string where =
          fmt::format("finding {} of kernel {}", json_of(finding.kind).dump(), json_of(finding.kernel).dump());
      if (Fault fault = check_numbers(where, finding)) return fault;
    }
    for (const WitnessRecord& witness : record_.witnesses) {
      if (Fault fault = check_witness(witness)) return fault;
    }
    return std::nullopt;
  }

 private:
  Fault check_witness(const WitnessRecord& witness) const {
    const std::string where = fmt::format("witness {}", json_of(witness.id).dump());
    if (Fault fault = check_numbers(where, witness)) return fault;
    const auto check_bits = [&](const std::optional<BitText>& bits, const char* member) -> Fault {
      if (!bits || bits->size() == comparisons_.size()) return std::nullopt;
      return fmt::format("{}: {} is {}, but the predicate {} has {} comparisons", where, member, json_of(*bits).dump(),
                         predicate_.id, comparisons_.size());
    };
    if (Fault fault = check_bits(witness.exact_comparisons, "exact_comparisons")) return fault;
    if (Fault fault = check_bits(witness.computed_comparisons, "computed_comparisons")) return fault;
    return witness.sides ? unknown(where + ", sides", "comparison", *witness.sides, comparisons_) : std::nullopt;
  }

  template <class Value>
  Fault unknown(const std::string& where, const char* kind, const NamedValues<Value>& given, const Names& names) const {
    for (const auto& [name, ignored] : given) {
      if (has(names, name)) continue;
      return fmt::format("{}: the predicate {} has no {} {}; it has: {}", where, predicate_.id, kind,
                         json_of(name).dump(), fmt::join(names, ", "));
    }
    return std::nullopt;
  }

  template <class Value>
  Fault all_and_no_other(const std::string& where, const char* kind, const std::optional<NamedValues<Value>>& given,
                         const Names& names) const {
    if (!given) return std::nullopt;
    if (Fault fault = unknown(where, kind, *given, names)) return fault;
    for (const std::string_view name : names) {
      if (!given->contains(name))
        return fmt::format("{}: without {} {} of the predicate {}", where, kind, name, predicate_.id);
    }
    return std::nullopt;
  }

  // The numbers of a query: those of one entry of the predicate, in its groups.
  Fault check_numbers(const std::string& where, const auto& query) const {
    const PredicateEntry* entry = entry_of(predicate_, query);
    if (entry == nullptr) {
      return fmt::format("{}: without the numbers of a query of {}: {}", where, predicate_.id,
                         fmt::join(group_names(predicate_.entries.front()), ", "));
    }
    const Names groups = group_names(*entry);
    for (const auto& [name, ignored] : query.numbers) {
      if (has(groups, name)) continue;
      return fmt::format("{}: {} is not a member, nor a name of numbers of the predicate {}, which are: {}", where,
                         json_of(name).dump(), predicate_.id, fmt::join(groups, ", "));
    }
    return std::nullopt;
  }

  const Record& record_;
  const Predicate& predicate_;
  Names clauses_, comparisons_;
};

}  // namespace

std::optional<std::string> fault_of_names(const Record& record) { return NameCheck(record).check(); }

const PredicateEntry* entry_of(const Predicate& predicate, const WitnessRecord& query) {
  return entry_of_numbers(predicate, query.numbers);
}
const PredicateEntry* entry_of(const Predicate& predicate, const FindingRecord& query) {
  return entry_of_numbers(predicate, query.numbers);
}

}  // namespace axiscert
