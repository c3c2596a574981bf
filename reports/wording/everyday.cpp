#include "reports/wording/everyday.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/queries/family.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr EnumArray<FamilyGroup, std::string_view> asked_words = {"everyday scenes", "of your own queries",
                                                                  "queries that nothing rounds",
                                                                  "hard queries (touching, degenerate, huge, tiny)"};

// "27 contacts invented, worst 16.6 cm (scene-edge)", or "none invented".
std::string side_text(std::uint64_t count, const char* what, const std::string& worst, const std::string& family) {
  if (count == 0) return fmt::format("none {}", what);
  return fmt::format("{} {} {}, worst {} ({})", thousands(count), count == 1 ? "contact" : "contacts", what, worst,
                     family);
}

// A length where one has a meaning; else a share.
std::string size_text(FamilyGroup group, double length, double depth, const LengthUnit* unit) {
  const std::string share = fmt::format("{} of the scene", amount(depth, 3));
  if (group == FamilyGroup::everyday)
    return length_text(length, unit != nullptr ? unit : find_length_unit("m")) + ", " + share;
  return group == FamilyGroup::own ? length_text(length, unit) + ", " + share : share;
}

std::string group_text(FamilyGroup group, const GroupResult& result, const LengthUnit* unit) {
  const std::string missed =
                        side_text(result.missed, "missed",
                                  size_text(group, result.worst_missed, result.deepest_missed, unit), result.missed_in),
                    invented = side_text(result.invented, "invented",
                                         size_text(group, result.worst_invented, result.deepest_invented, unit),
                                         result.invented_in);
  std::string text = fmt::format("{} {}: ", thousands(result.looked_at), asked_words[group]);
  if (result.no_answer == result.looked_at) return text + "no verdict";
  if (result.missed + result.invented == 0) text += "no wrong verdict";
  else text += result.missed == 0 && result.invented != 0 ? invented + "; " + missed : missed + "; " + invented;
  if (result.no_answer != 0) text += fmt::format("; {} without a verdict", thousands(result.no_answer));
  return text;
}

std::string window_text(const WindowRecord& window) {
  const std::string asked = fmt::format("2^{} to 2^{}", window.scanned_low, window.scanned_high);
  if (window.is_whole()) return fmt::format("in other units: as in this one, times {}", asked);
  if (window.low == 0 && window.high == 0)
    return fmt::format("in other units: other answers at half the unit and at twice it ({} were asked)", asked);
  return fmt::format("in other units: as in this one only from 2^{} to 2^{} times it ({} were asked)", window.low,
                     window.high, asked);
}

}  // namespace

FamilyGroup family_group(std::string_view name) {
  if (name.starts_with("mesh/") || name.starts_with("queries/")) return FamilyGroup::own;
  for (const Family* family : families()) {
    if (family->name != name) continue;
    if (family->trust_group == TrustGroup::scene) return FamilyGroup::everyday;
    return family->exact_arithmetic ? FamilyGroup::exact : FamilyGroup::hard;
  }
  return FamilyGroup::hard;
}

GroupResult group_result(const KernelRecord& kernel, FamilyGroup group) {
  GroupResult out;
  for (const auto& [family, result] : kernel.families) {
    if (family_group(family) != group) continue;
    const VerdictTally& verdict = result.verdict;
    const Evidence evidence = evidence_of(kernel, result);
    if (evidence.promised() == 0) continue;
    ++out.families;
    out.looked_at += evidence.promised();
    out.missed += verdict.false_separation;
    out.invented += verdict.false_contact;
    out.no_answer += evidence.declined() + evidence.invalid + evidence.unanswered;
    const auto offer = [&, family = family](double length, double depth, double& farthest, double& deepest,
                                            std::string& in) {
      if (length > farthest || in.empty()) in = family;
      farthest = std::max(farthest, length);
      deepest = std::max(deepest, depth);
    };
    if (verdict.false_separation != 0) {
      offer(verdict.farthest_false_separation.best(), verdict.deepest_false_separation.best(), out.worst_missed,
            out.deepest_missed, out.missed_in);
    }
    if (verdict.false_contact != 0) {
      offer(verdict.farthest_false_contact.best(), verdict.deepest_false_contact.best(), out.worst_invented,
            out.deepest_invented, out.invented_in);
    }
  }
  return out;
}

std::vector<std::string> first_sentences(const KernelRecord& kernel, const PlanRecord& plan) {
  std::vector<std::string> sentences;
  for (const FamilyGroup group : enumerators<FamilyGroup>) {
    const GroupResult result = group_result(kernel, group);
    if (result.families != 0) sentences.push_back(group_text(group, result, unit_of(plan)));
  }
  if (kernel.window) sentences.push_back(window_text(*kernel.window));
  return sentences;
}

}  // namespace axiscert
