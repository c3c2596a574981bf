#include "reports/formats/sections/signs_section.h"

#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

using Cells = std::vector<std::string>;

std::string measured(std::optional<std::uint64_t> count) { return count ? thousands(*count) : "not measured"; }

// The figures that only one of the two levels has.
Cells own_cells(const AxisTally& tally) { return {measured(tally.sole_separator)}; }
Cells own_cells(const ComparisonTally& tally) {
  return {measured(tally.ties), measured(tally.range_events), measured(tally.error_without_scale)};
}

template <class Tally>
std::string signs_section(const std::string& title, const std::string& level, const Cells& own_columns,
                          const Record& record, const std::vector<std::optional<FamilyRecord>>& totals,
                          std::optional<NamedValues<Tally>> FamilyCounts::*signs) {
  Section section(title);
  Cells columns = {"kernel", "precision",          level,        "false_separation", "missed_separation", "decisive",
                   "masked", "tolerance failures", "max_error_u"};
  columns.insert(columns.end(), own_columns.begin(), own_columns.end());
  section.add_head(columns, 3);
  std::vector<Cells> with_flips, without;
  for (std::size_t k = 0; k < totals.size(); ++k) {
    if (!totals[k]) continue;
    const KernelRecord& kernel = record.kernels[k];
    const Cells of = {markdown_text(kernel.id), std::string(name(kernel.precision))};
    if (!((*totals[k]).*signs)) {
      Cells& cells = without.emplace_back(of);
      cells.emplace_back("not exposed");
      cells.resize(columns.size());
      continue;
    }
    for (const auto& [sign, tally] : *((*totals[k]).*signs)) {
      const bool has_flips = tally.false_separation != 0 || tally.missed_separation != 0;
      Cells& cells = (has_flips ? with_flips : without).emplace_back(of);
      cells.push_back(sign);
      for (const std::optional<std::uint64_t> count :
           {std::optional(tally.false_separation), std::optional(tally.missed_separation),
            std::optional(tally.decisive), std::optional(tally.masked), tally.tolerance_failures})
        cells.push_back(count_text(count));
      cells.push_back(error_amount(tally.max_error));
      for (const std::string& cell : own_cells(tally)) cells.push_back(cell);
    }
  }
  for (const auto* rows : {&with_flips, &without}) {
    for (const Cells& cells : *rows) section.add_row(cells);
  }
  section.add_line("\nmax_error_u is also the smallest tolerance that passes.");
  return section.text();
}

}  // namespace

std::string axes_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals) {
  return signs_section("Axes, over all families", "axis", {"sole_separator"}, record, totals, &FamilyCounts::axes);
}
std::string comparisons_section(const Record& record, const std::vector<std::optional<FamilyRecord>>& totals) {
  return signs_section("Comparisons, over all families", "comparison", {"ties", "range_events", "error_without_scale"},
                       record, totals, &FamilyCounts::comparisons);
}

}  // namespace axiscert
