#include "reports/certificate/findings/situations.h"

#include <algorithm>

#include "fuzz/files/corpus.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

const Situation* situation_of(const TestDescription& test, std::string_view name) {
  for (const Family* family : families_of(test)) {
    if (family->name == name) return family->situation;
  }
  return name == corpus_name ? &of_corpus : &capabilities_of(test).situations->own;
}

// The wrong verdicts of one situation in one precision.
struct WrongVerdicts {
  std::uint64_t missed = 0, phantom = 0;
  double deepest_missed = 0, deepest_phantom = 0;
  std::vector<std::pair<double, std::string>> families = {};  // by their deepest

  void add(const std::string& family, const VerdictTally& verdict) {
    const std::uint64_t more = verdict.false_separation, others = verdict.false_contact;
    if (more + others == 0) return;
    const double of_missed = verdict.deepest_false_separation.best(), of_phantom = verdict.deepest_false_contact.best();
    missed += more;
    phantom += others;
    deepest_missed = std::max(deepest_missed, of_missed);
    deepest_phantom = std::max(deepest_phantom, of_phantom);
    families.emplace_back(std::max(of_missed, of_phantom), family);
  }
};

}  // namespace

Json situations_json(const Record& record, const std::string& kernel) {
  Json found = Json::array();
  const TestDescription& test = test_of(record.plan);
  const Situations* situations = capabilities_of(test).situations;
  if (situations == nullptr) return found;
  std::vector<const Situation*> in_order(situations->of_families.begin(), situations->of_families.end());
  in_order.insert(in_order.end(), {&of_corpus, &situations->own});
  for (const Situation* situation : in_order) {
    for (const KernelRecord& entry : record.kernels) {
      if (entry.id != kernel) continue;
      WrongVerdicts tally;
      for (const auto& [family, result] : entry.families) {
        if (situation_of(test, family) == situation) tally.add(family, result.verdict);
      }
      if (tally.families.empty()) continue;
      std::ranges::stable_sort(tally.families, [](const auto& x, const auto& y) { return x.first > y.first; });
      Json families = Json::array();
      for (const auto& [depth, family] : tally.families) families.push_back(family);
      found.push_back({{"precision", name(entry.precision)},
                       {"situation", situation->name},
                       {"meaning", situation->meaning},
                       {"families", families},
                       {"missed", tally.missed},
                       {"deepest_missed", tally.deepest_missed},
                       {"phantom", tally.phantom},
                       {"deepest_phantom", tally.deepest_phantom},
                       {"advice", situation->advice},
                       {"section", situation->section}});
    }
  }
  return found;
}

const Json* first_situation(const Json& situations, bool& missed) {
  for (const bool is_missed : {true, false}) {
    const char* depth = is_missed ? "deepest_missed" : "deepest_phantom";
    missed = is_missed;
    for (const Json& entry : situations) {
      if (entry[depth].get<double>() >= visible_depth) return &entry;
    }
  }
  for (const bool is_missed : {true, false}) {
    const char *count = is_missed ? "missed" : "phantom", *depth = is_missed ? "deepest_missed" : "deepest_phantom";
    missed = is_missed;
    const Json* deepest = nullptr;
    for (const Json& entry : situations) {
      if (entry[count] != 0 && (!deepest || entry[depth].get<double>() > (*deepest)[depth].get<double>()))
        deepest = &entry;
    }
    if (deepest) return deepest;
  }
  return nullptr;
}

}  // namespace axiscert
