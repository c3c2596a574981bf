#include "reports/run_folder/record_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

using Fault = std::optional<std::string>;
using Names = std::vector<std::string_view>;

// The members besides the numbers of the query.
constexpr std::array<std::string_view, 17> witness_members = {
    "id",       "precision", "kernel", "family",   "address",           "truth",
    "computed", "touching",  "depth",  "sides",    "exact_comparisons", "computed_comparisons",
    "shows",    "flips",     "class",  "measures", "first_contact"};
constexpr std::array<std::string_view, 7> finding_members = {"kernel", "precision", "family", "kind",
                                                             "count",  "detail",    "address"};

bool has(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Named>
Names names_of(const std::vector<Named>& all) {
  Names names;
  for (const Named& one : all) names.push_back(one.name);
  return names;
}

Names group_names(const TestEntry& entry) {
  Names names;
  for (const ColumnGroup& group : groups_of(entry)) names.push_back(group.name);
  return names;
}

class NameCheck {
 public:
  explicit NameCheck(const Json& record)
      : record_(record),
        test_(test_of(record["plan"])),
        clauses_(names_of(test_.clauses)),
        comparisons_(names_of(test_.comparisons)) {}

  Fault check() const {
    if (Fault fault = unknown("tolerance", "comparison", record_["plan"]["tolerance"], comparisons_)) return fault;
    for (const Json& kernel : record_["kernels"]) {
      for (const auto& [family, result] : kernel["families"].items()) {
        const std::string where = fmt::format("kernel {} in {}, family {}", kernel["id"].dump(),
                                              kernel["precision"].get<std::string>(), Json(family).dump());
        if (Fault fault = all_and_no_other(where, "axis", result["axes"], clauses_)) return fault;
        if (Fault fault = all_and_no_other(where, "comparison", result["comparisons"], comparisons_)) return fault;
      }
    }
    for (const Json& finding : record_["findings"]) {
      const std::string where =
          fmt::format("finding {} of kernel {}", finding["kind"].dump(), finding["kernel"].dump());
      if (Fault fault = numbers(where, finding, finding_members)) return fault;
    }
    for (const Json& witness : record_["witnesses"]) {
      if (Fault fault = check_witness(witness)) return fault;
    }
    return std::nullopt;
  }

 private:
  Fault check_witness(const Json& witness) const {
    const std::string where = fmt::format("witness {}", witness["id"].dump());
    if (Fault fault = numbers(where, witness, witness_members)) return fault;
    for (const char* member : {"exact_comparisons", "computed_comparisons"}) {
      if (witness[member].is_null() || witness[member].get_ref<const std::string&>().size() == comparisons_.size())
        continue;
      return fmt::format("{}: {} is {}, but the test {} has {} comparisons", where, member, witness[member].dump(),
                         test_.id, comparisons_.size());
    }
    if (!witness.contains("sides") || witness["sides"].is_null()) return std::nullopt;
    return unknown(where + ", sides", "comparison", witness["sides"], comparisons_);
  }

  Fault unknown(const std::string& where, const char* kind, const Json& given, const Names& names) const {
    for (const auto& [name, ignored] : given.items()) {
      if (has(names, name)) continue;
      return fmt::format("{}: the test {} has no {} {}; it has: {}", where, test_.id, kind, Json(name).dump(),
                         fmt::join(names, ", "));
    }
    return std::nullopt;
  }

  Fault all_and_no_other(const std::string& where, const char* kind, const Json& given, const Names& names) const {
    if (given.is_null()) return std::nullopt;
    if (Fault fault = unknown(where, kind, given, names)) return fault;
    for (const std::string_view name : names) {
      if (!given.contains(name)) return fmt::format("{}: without {} {} of the test {}", where, kind, name, test_.id);
    }
    return std::nullopt;
  }

  // The numbers of a query: those of one entry of the test, in its groups.
  template <class Members>
  Fault numbers(const std::string& where, const Json& query, const Members& members) const {
    const TestEntry* entry = entry_of(test_, query);
    if (entry == nullptr) {
      return fmt::format("{}: without the numbers of a query of {}: {}", where, test_.id,
                         fmt::join(group_names(test_.entries.front()), ", "));
    }
    const Names groups = group_names(*entry);
    for (const auto& [name, ignored] : query.items()) {
      if (has(members, name) || has(groups, name)) continue;
      return fmt::format("{}: {} is not a member, nor a name of numbers of the test {}, which are: {}", where,
                         Json(name).dump(), test_.id, fmt::join(groups, ", "));
    }
    return std::nullopt;
  }

  const Json& record_;
  const TestDescription& test_;
  Names clauses_, comparisons_;
};

}  // namespace

std::optional<std::string> fault_of_names(const Json& record) { return NameCheck(record).check(); }

const TestEntry* entry_of(const TestDescription& test, const Json& query) {
  const auto fits = [&](const ColumnGroup& group) {
    const auto member = query.find(std::string(group.name));
    if (member == query.end()) return false;
    return member->is_null() || (member->is_array() ? member->size() == group.size : group.size == 1);
  };
  // One entry's groups may be among another's: that with most is meant.
  const TestEntry* found = nullptr;
  std::size_t most = 0;
  for (const TestEntry& entry : test.entries) {
    const std::vector<ColumnGroup> groups = groups_of(entry);
    if (groups.size() <= most || !std::all_of(groups.begin(), groups.end(), fits)) continue;
    found = &entry;
    most = groups.size();
  }
  return found;
}

}  // namespace axiscert
