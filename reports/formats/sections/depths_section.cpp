#include "reports/formats/sections/depths_section.h"

#include <fmt/format.h>

#include "reports/wording/depths.h"
#include "reports/wording/markdown_text.h"

namespace axiscert {
namespace {

// Adds a row for each direction in which a verdict of `family` is wrong.
void add_depth_rows(Section& section, const Json& kernel, const std::string& name, const Json& family) {
  for (const auto& [kind, what] : {std::pair("false_separation", "missed"), {"false_contact", "phantom"}}) {
    if (family["verdict"][kind] == 0) continue;
    std::vector<std::string> cells = {plain(kernel["id"]), kernel["precision"], plain(name), what};
    for (const std::uint64_t count : depth_counts(family["verdict"]["depths"][kind])) cells.push_back(thousands(count));
    section.row(cells);
  }
}

}  // namespace

std::string depths_section(const Json& record) {
  Section section("Depth of wrong verdicts");
  section.line(
      "Wrong verdicts by depth, each column from its depth to that of the next one; zero is a sphere that touches. An "
      "engine-like query has numbers that are zero or normal, coordinates to 2^20 and a radius from 2^-20 to 2^20; a "
      "wrong "
      "verdict counts there where its depth is above 16 u.\n");
  std::vector<std::string> columns = {"kernel", "precision", "family", "wrong"};
  columns.insert(columns.end(), depth_columns().begin(), depth_columns().end());
  section.head(columns, 4);
  bool any = false;
  std::string sentences;
  for (const Json& kernel : record["kernels"]) {
    const Json total = all_families(kernel);
    if (!has_depths(total)) continue;
    const Json& verdict = total["verdict"];
    if (verdict["false_separation"] == 0 && verdict["false_contact"] == 0) continue;
    any = true;
    add_depth_rows(section, kernel, "all", total);
    for (const auto& [family, result] : kernel["families"].items()) add_depth_rows(section, kernel, family, result);
    for (const std::string& told : {engine_text(total), bias_text(total)}) {
      if (!told.empty())
        sentences += fmt::format("\n{} {}: {}.\n", plain(kernel["id"]), kernel["precision"].get<std::string>(), told);
    }
  }
  section.add(sentences);
  return any ? section.text() : "";
}

}  // namespace axiscert
