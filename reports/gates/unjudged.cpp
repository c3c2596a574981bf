#include "reports/gates/requirement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/gates/enough.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Valid queries of a family that one kernel was asked, in all of its precisions.
std::uint64_t valid_queries(const Record& record, const std::string& id, const std::string& family) {
  std::uint64_t sum = 0;
  for (const KernelRecord& kernel : record.kernels) {
    const FamilyRecord* result = kernel.families.find(family);
    if (kernel.id == id && result != nullptr) sum += evidence_of(kernel, *result).population;
  }
  return sum;
}

// Families of which one kernel was asked queries in one precision, and none of them is valid.
std::vector<std::string> without_valid(const KernelRecord& kernel) {
  std::vector<std::string> families;
  for (const auto& [family, result] : kernel.families) {
    if (result.trials != 0 && evidence_of(kernel, result).population == 0) families.push_back(family);
  }
  return families;
}

// Why a kernel in one precision gave nothing to judge; empty where it did, and where it was asked nothing.
std::string nothing_of(const KernelRecord& kernel) {
  const Evidence evidence = evidence_of(kernel);
  if (evidence.population == 0 || evidence.decided() != 0) return "";
  if (evidence.promised() == 0) {
    return evidence.outside == evidence.population ? "every valid query is outside the limits that it declares"
                                                   : "it promises nothing of any valid query";
  }
  std::vector<std::string> parts = no_verdict_words(evidence.no_verdict());
  parts.insert(parts.begin(),
               fmt::format("of {} valid queries that it promises it decided none", thousands(evidence.promised())));
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

std::vector<std::string> unjudged(const Record& record) {
  std::vector<std::string> sentences;
  const std::vector<std::string> unloaded = not_judged(record);
  for (const std::string& id : unloaded) {
    std::string why;
    for (const FindingRecord& finding : record.findings) {
      if (finding.kernel == id) why = ": " + finding.detail;
    }
    sentences.push_back(fmt::format("{}: NOT JUDGED: it could not be loaded{}", id, why));
  }
  for (const std::string& id : record.plan.kernels) {
    if (std::find(unloaded.begin(), unloaded.end(), id) != unloaded.end()) continue;
    std::vector<std::string> empty;
    for (const std::string& family : record.plan.families) {
      if (valid_queries(record, id, family) == 0) empty.push_back(family);
    }
    if (!empty.empty()) {
      sentences.push_back(fmt::format("{}: NOT JUDGED on {}: no valid query in a precision in which it exists", id,
                                      fmt::join(empty, ", ")));
    }
    for (const UntakenLines& lines : lines_it_cannot_take(record, id))
      sentences.push_back(fmt::format("{}: NOT JUDGED on {}", id, lines.text()));
    for (const KernelRecord* kernel : precision_entries(record, id)) {
      std::vector<std::string> here = without_valid(*kernel);
      std::erase_if(here, [&](const std::string& family) { return std::ranges::find(empty, family) != empty.end(); });
      if (!here.empty()) {
        sentences.push_back(fmt::format("{} {}: NOT JUDGED on {}: none of its queries is valid", id,
                                        name(kernel->precision), fmt::join(here, ", ")));
      }
      if (const std::string why = nothing_of(*kernel); !why.empty())
        sentences.push_back(fmt::format("{} {}: NOT JUDGED: {}", id, name(kernel->precision), why));
    }
  }
  return sentences;
}

}  // namespace axiscert
