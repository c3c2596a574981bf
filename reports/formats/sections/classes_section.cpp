#include "reports/formats/sections/classes_section.h"

#include <fmt/format.h>

#include "reports/wording/classes.h"
#include "reports/wording/markdown_text.h"

namespace axiscert {

std::string classes_section(const Record& record) {
  Section section("Why, by the class of the input");
  section.add_line(
      "Kernels whose links do not say why they are wrong: each wrong verdict is in the first of these classes whose "
      "definition its input meets.\n");
  bool any = false;
  section.add_head({"kernel", "precision", "class", "what it says", "deepest witness", "missed contacts",
                    "phantom contacts", "deepest"},
                   5);
  for (const KernelRecord& kernel : record.kernels) {
    for (const ClassRow& row : class_rows(kernel)) {
      any = true;
      section.add_row({markdown_text(kernel.id), std::string(name(kernel.precision)), std::string(name(row.which)),
                       std::string(class_words[row.which].meaning), markdown_text(row.witness), thousands(row.missed),
                       thousands(row.phantom), amount(row.deepest, 4)});
    }
  }
  for (const KernelRecord& kernel : record.kernels) {
    const std::string nearest = nearest_sentence(kernel);
    if (nearest.empty()) continue;
    section.add_line(
        fmt::format("\n{} {}: {}.", markdown_text(kernel.id), name(kernel.precision), markdown_text(nearest, 2000)));
  }
  return any ? section.text() : "";
}

}  // namespace axiscert
