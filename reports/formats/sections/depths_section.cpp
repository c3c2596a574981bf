#include "reports/formats/sections/depths_section.h"

#include <fmt/format.h>

#include "reports/wording/depths.h"
#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

// Adds a row for each direction in which a verdict of `family` is wrong.
void add_depth_rows(Section& section, const KernelRecord& kernel, const std::string& family_name,
                    const FamilyRecord& family) {
  const VerdictTally& verdict = family.verdict;
  const auto add = [&](const char* what, std::uint64_t wrong, const DecadeCounts& depths) {
    if (wrong == 0) return;
    std::vector<std::string> cells = {markdown_text(kernel.id), std::string(name(kernel.precision)),
                                      markdown_text(family_name), what};
    for (const std::uint64_t count : depth_counts(depths)) cells.push_back(thousands(count));
    section.add_row(cells);
  };
  if (!verdict.depths) return;
  add("missed", verdict.false_separation, verdict.depths->false_separation);
  add("phantom", verdict.false_contact, verdict.depths->false_contact);
}

}  // namespace

std::string depths_section(const Record& record) {
  Section section("Depth of wrong verdicts");
  section.add_line(
      "Wrong verdicts by depth, each column from its depth to that of the next one; zero is a sphere that touches. An "
      "engine-like query has numbers that are zero or normal, coordinates to 2^20 and a radius from 2^-20 to 2^20; a "
      "wrong "
      "verdict counts there where its depth is above 16 u.\n");
  std::vector<std::string> columns = {"kernel", "precision", "family", "wrong"};
  columns.insert(columns.end(), depth_columns().begin(), depth_columns().end());
  section.add_head(columns, 4);
  bool any = false;
  std::string sentences;
  for (const KernelRecord& kernel : record.kernels) {
    const std::optional<FamilyRecord> total = all_families(kernel);
    if (!total || !total->verdict.depths) continue;
    if (total->verdict.false_separation == 0 && total->verdict.false_contact == 0) continue;
    any = true;
    add_depth_rows(section, kernel, "all", *total);
    for (const auto& [family, result] : kernel.families) add_depth_rows(section, kernel, family, result);
    for (const std::string& told : {engine_text(*total), bias_text(*total)}) {
      if (!told.empty())
        sentences += fmt::format("\n{} {}: {}.\n", markdown_text(kernel.id), name(kernel.precision), told);
    }
  }
  section.add(sentences);
  return any ? section.text() : "";
}

}  // namespace axiscert
