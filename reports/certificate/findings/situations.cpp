#include "reports/certificate/findings/situations.h"

#include <algorithm>

#include "reports/certificate/findings/test_words.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {
namespace {

bool has_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != words.npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

const Situation& situation_of(std::span<const Situation> situations, std::string_view family) {
  const std::string_view own = family.substr(family.find('/') + 1);
  for (const Situation& situation : situations) {
    if (has_word(situation.families, own)) return situation;
  }
  return situations.back();
}

}  // namespace

std::vector<WrongVerdicts> wrong_situations(const Record& record, const std::string& kernel) {
  std::vector<WrongVerdicts> found;
  const std::span<const Situation> situations = test_words_of(test_of(record.plan)).situations;
  for (const Situation& situation : situations) {
    for (const KernelRecord& entry : record.kernels) {
      if (entry.id != kernel) continue;
      WrongVerdicts wrong{&situation, entry.precision};
      std::vector<std::pair<double, std::string>> families;  // by their deepest
      for (const auto& [family, result] : entry.families) {
        const VerdictTally& verdict = result.verdict;
        if (&situation_of(situations, family) != &situation) continue;
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
