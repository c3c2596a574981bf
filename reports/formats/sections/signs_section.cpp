#include "reports/formats/sections/signs_section.h"

#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

std::vector<std::string> sign_columns(const std::string& level) {
  std::vector<std::string> columns = {"kernel",           "precision",          level == "axes" ? "axis" : "comparison",
                                      "false_separation", "missed_separation",  "decisive",
                                      "masked",           "tolerance failures", "max_error_u"};
  if (level == "axes") columns.push_back("sole_separator");
  else columns.insert(columns.end(), {"ties", "range_events", "error_without_scale"});
  return columns;
}

}  // namespace

std::string signs_section(const Json& record, const std::vector<Json>& totals, const std::string& level) {
  Section section(level == "axes" ? "Axes, over all families" : "Comparisons, over all families");
  const std::vector<std::string> columns = sign_columns(level);
  section.head(columns, 3);
  std::vector<std::vector<std::string>> with_flips, without;
  for (std::size_t k = 0; k < totals.size(); ++k) {
    const Json& kernel = record["kernels"][k];
    if (totals[k].empty()) continue;
    if (totals[k][level].is_null()) {
      std::vector<std::string> cells = {plain(kernel["id"]), kernel["precision"], "not exposed"};
      cells.resize(columns.size());
      without.push_back(cells);
      continue;
    }
    for (const auto& [name, tally] : totals[k][level].items()) {
      std::vector<std::string> cells = {plain(kernel["id"]), kernel["precision"], name};
      for (const char* member : {"false_separation", "missed_separation", "decisive", "masked", "tolerance_failures"})
        cells.push_back(count_text(tally[member]));
      cells.push_back(error_amount(tally["max_error_u"]));
      for (std::size_t i = cells.size(); i < columns.size(); ++i)
        cells.push_back(tally[columns[i]].is_null() ? "not measured" : count_text(tally[columns[i]]));
      const bool has_flips = tally["false_separation"] != 0 || tally["missed_separation"] != 0;
      (has_flips ? with_flips : without).push_back(cells);
    }
  }
  for (const auto* rows : {&with_flips, &without}) {
    for (const auto& cells : *rows) section.row(cells);
  }
  section.line("\nmax_error_u is also the smallest tolerance that passes.");
  return section.text();
}

}  // namespace axiscert
