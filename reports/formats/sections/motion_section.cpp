#include "reports/formats/sections/motion_section.h"

#include "reports/wording/markdown_text.h"
#include "reports/wording/motion.h"
#include "reports/wording/summary.h"

namespace axiscert {

std::string motion_section(const Record& record) {
  Section section("First contacts");
  section.add_line(std::string(motion_note) + "\n");
  std::vector<std::string> columns = {"kernel", "precision", "family"};
  columns.insert(columns.end(), motion_columns().begin(), motion_columns().end());
  section.add_head(columns, 3);
  bool any = false;
  for (const KernelRecord& kernel : record.kernels) {
    const auto add = [&](const std::string& shown_name, const FamilyRecord& family) {
      const std::vector<std::string> cells = motion_cells(family);
      if (cells.empty()) return;
      any = true;
      std::vector<std::string> row = {markdown_text(kernel.id), std::string(name(kernel.precision)),
                                      markdown_text(shown_name)};
      row.insert(row.end(), cells.begin(), cells.end());
      section.add_row(row);
    };
    if (const auto total = all_families(kernel)) add("all", *total);
    for (const auto& [family, result] : kernel.families) add(family, result);
  }
  return any ? section.text() : "";
}

}  // namespace axiscert
