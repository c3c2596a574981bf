#include "reports/wording/classes.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/record/wrong_verdicts.h"
#include "fuzz/text/json.h"
#include "reports/wording/summary.h"

namespace axiscert {

const EnumArray<InputClass, CauseWords> class_words = {{
    {"the sphere touches the triangle exactly: the last bit of any rounding decides",
     "Let r grow by the safe margin, or use a test that is right at the tie, as libaxiscert is.",
     "docs/certified.md#what-is-promised"},
    {"the depth is at most 64 u: rounding alone may explain it",
     "Rounding: let r grow by the safe margin, or use libaxiscert.", "docs/certified.md#what-is-promised"},
    {"a length is past the range in which formulae of degree 6 neither overflow nor underflow",
     "Bring the scene to a unit of length in which its numbers lie within the window of degree 6.",
     "docs/error_model.md#units-of-length"},
    {"two vertices of the triangle are equal",
     "Drop triangles with two equal vertices when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"the three vertices are on a line: the triangle has no area",
     "Drop triangles without area when the mesh is read, or take a test that is right on them.",
     "docs/precision.md#the-reduced-rung"},
    {"the triangle is less than a thousandth as high as it is long",
     "Mend slivers when the mesh is read, or take a test with more precision for them.",
     "docs/precision.md#the-ladder"},
    {"the origin is at least 64 times as far away as the scene is long: the kernel loses digits of the coordinates",
     "Subtract an origin near the scene before the numbers are rounded to the test's precision.",
     "docs/precision.md#flips-caused-by-the-query-and-by-the-formula"},
    {"neither the shape, the place nor the scale of the input excuses it: look for a fault of logic, or for a constant "
     "such as an epsilon",
     "Look for a fault of logic, or an absolute number: `axiscert check` the witness, and `axiscert map` it.",
     "docs/error_model.md#the-class-of-the-input"},
}};

bool has_classes(const KernelRecord& kernel) {
  return std::any_of(kernel.families.begin(), kernel.families.end(),
                     [](const auto& family) { return family.second.classes.has_value(); });
}

std::vector<ClassRow> class_rows(const KernelRecord& kernel) {
  std::vector<ClassRow> rows;
  for (const InputClass which : enumerators<InputClass>) {
    ClassRow row{which, 0, 0, 0, "", ""};
    for (const auto& [family, result] : kernel.families) {
      if (!result.classes) continue;
      const auto found = result.classes->find(which);
      if (found == result.classes->end()) continue;
      const ClassRecord& of = found->second;
      row.missed += of.false_separation;
      row.phantom += of.false_contact;
      if (row.witness.empty() || of.deepest.best() > row.deepest) {
        row.deepest = of.deepest.best();
        row.family = family;
        row.witness = of.witness;
      }
    }
    if (row.missed + row.phantom != 0) rows.push_back(row);
  }
  return rows;
}

std::string nearest_sentence(const KernelRecord& kernel) {
  if (!kernel.nearest || !*kernel.nearest) return "";
  const NearestRecord& nearest = **kernel.nearest;
  return fmt::format(
      "{}{}, wrong on {} % of the queries on which either is ({} of {}, among {}: the first {} of each family and the "
      "deepest)",
      2 * nearest.both >= nearest.either ? "Nearest of the built-in kernels: "
                                         : "No built-in kernel fails alike; the nearest is ",
      nearest.kernel, amount(100 * static_cast<double>(nearest.both) / static_cast<double>(nearest.either), 3),
      thousands(nearest.both), thousands(nearest.either), thousands(nearest.queries), thousands(nearest_queries));
}

Json classes_data(const KernelRecord& kernel) {
  if (!has_classes(kernel)) return nullptr;
  Json rows = Json::array();
  for (const ClassRow& row : class_rows(kernel)) {
    rows.push_back({{"class", input_class_names[row.which]},
                    {"meaning", class_words[row.which].meaning},
                    {"missed", row.missed},
                    {"phantom", row.phantom},
                    {"deepest", row.deepest},
                    {"family", row.family},
                    {"witness", row.witness}});
  }
  return {{"rows", std::move(rows)}, {"nearest", nearest_sentence(kernel)}};
}

}  // namespace axiscert
