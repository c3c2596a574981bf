#include "reports/run_folder/record_classes.h"

#include <fmt/format.h>

#include <tuple>

namespace axiscert {

std::optional<std::string> fault_of_classes(const KernelRecord& kernel, const FamilyRecord& family) {
  if (!family.classes) return std::nullopt;
  if (kernel.reference == true) return "classes of a kernel with a reference, whose links say why it is wrong";
  const VerdictTally& verdict = family.verdict;
  std::uint64_t missed = 0, phantom = 0, ties = 0;
  for (const auto& [which, of] : *family.classes) {
    missed += of.false_separation;
    phantom += of.false_contact;
  }
  for (const auto& [kind, sum, whole] : {std::tuple("false_separation", missed, verdict.false_separation),
                                         {"false_contact", phantom, verdict.false_contact}}) {
    if (sum != whole) return fmt::format("the classes have {} {} verdicts, but the family {}", sum, kind, whole);
  }
  for (const auto& [which, of] : *family.classes) {
    const std::uint64_t wrong = of.false_separation + of.false_contact;
    if (wrong == 0) return fmt::format("class {} has no wrong verdict", name(which));
    if (of.deepest.best() > verdict.deepest())
      return fmt::format("the deepest of class {} is deeper than the deepest of the family", name(which));
    if (which == InputClass::tie) ties = wrong;
  }
  if (ties != verdict.touching_flips) return "class tie and touching_flips do not agree";
  return std::nullopt;
}

std::optional<std::string> fault_of_depths(const VerdictTally& verdict, std::uint64_t valid) {
  if (verdict.depths) {
    for (const auto& [kind, decades, whole] :
         {std::tuple("false_separation", verdict.depths->false_separation, verdict.false_separation),
          {"false_contact", verdict.depths->false_contact, verdict.false_contact}}) {
      if (decades.sum() != whole) return fmt::format("depths do not add up to {}", kind);
    }
  }
  if (!verdict.engine) return std::nullopt;
  for (const auto& [kind, part, whole] :
       {std::tuple("false_separation", verdict.engine->false_separation(), verdict.false_separation),
        {"false_contact", verdict.engine->false_contact(), verdict.false_contact}}) {
    if (part > whole) return fmt::format("more {} on engine-like queries than on all", kind);
  }
  if (verdict.engine->queries > valid) return "more engine-like queries than valid ones";
  return std::nullopt;
}

}  // namespace axiscert
