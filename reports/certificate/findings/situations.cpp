#include "reports/certificate/findings/situations.h"

#include <algorithm>

#include "fuzz/files/corpus.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

const Situation* situation_of(const Predicate& predicate, std::string_view name) {
  for (const Family* family : families_of(predicate)) {
    if (family->name == name) return family->situation;
  }
  return name == corpus_name ? &of_corpus : &capabilities_of(predicate).situations->own;
}

}  // namespace

std::vector<WrongVerdicts> wrong_situations(const Record& record, const std::string& kernel) {
  std::vector<WrongVerdicts> found;
  const Predicate& predicate = predicate_of(record.plan);
  const Situations* situations = capabilities_of(predicate).situations;
  if (situations == nullptr) return found;
  std::vector<const Situation*> in_order(situations->of_families.begin(), situations->of_families.end());
  in_order.insert(in_order.end(), {&of_corpus, &situations->own});
  for (const Situation* situation : in_order) {
    for (const KernelRecord& entry : record.kernels) {
      if (entry.id != kernel) continue;
      WrongVerdicts wrong{situation, entry.precision};
      std::vector<std::pair<double, std::string>> families;  // by their deepest
      for (const auto& [family, result] : entry.families) {
        const VerdictTally& verdict = result.verdict;
        if (situation_of(predicate, family) != situation) continue;
        if (verdict.false_separation + verdict.false_contact == 0) continue;
        const double missed = verdict.deepest_false_separation.best(), phantom = verdict.deepest_false_contact.best();
        wrong.missed += verdict.false_separation;
        wrong.phantom += verdict.false_contact;
        wrong.deepest_missed = std::max(wrong.deepest_missed, missed);
        wrong.deepest_phantom = std::max(wrong.deepest_phantom, phantom);
        families.emplace_back(std::max(missed, phantom), family);
      }
      if (families.empty()) continue;
      std::ranges::stable_sort(families, [](const auto& x, const auto& y) { return x.first > y.first; });
      for (const auto& [depth, family] : families) wrong.families.push_back(family);
      found.push_back(std::move(wrong));
    }
  }
  return found;
}

const WrongVerdicts* first_situation(const std::vector<WrongVerdicts>& situations, bool& missed) {
  for (const bool is_missed : {true, false}) {
    missed = is_missed;
    for (const WrongVerdicts& entry : situations) {
      if (entry.deepest(is_missed) >= visible_depth) return &entry;
    }
  }
  for (const bool is_missed : {true, false}) {
    missed = is_missed;
    const WrongVerdicts* deepest = nullptr;
    for (const WrongVerdicts& entry : situations) {
      if (entry.count(is_missed) != 0 && (!deepest || entry.deepest(is_missed) > deepest->deepest(is_missed)))
        deepest = &entry;
    }
    if (deepest) return deepest;
  }
  return nullptr;
}

}  // namespace axiscert
