#include "reports/wording/classes.h"

#include <fmt/format.h>

#include "fuzz/campaign/counts/class_tally.h"
#include "reports/wording/summary.h"

namespace axiscert {

const EnumArray<InputClass, std::string_view> class_meanings = {
    "the sphere touches the triangle exactly: the last bit of any rounding decides",
    "the depth is at most 64 u: rounding alone may explain it",
    "a length is past the range in which formulae of degree 6 neither overflow nor underflow",
    "two vertices of the triangle are equal",
    "the three vertices are on a line: the triangle has no area",
    "the triangle is less than a thousandth as high as it is long",
    "the origin is at least 64 times as far away as the scene is long: the kernel loses digits of the coordinates",
    "neither the shape, the place nor the scale of the input excuses it: look for a fault of logic, or for a constant "
    "such as an epsilon"};

bool has_classes(const Json& kernel) {
  for (const auto& [family, result] : kernel["families"].items()) {
    if (result.contains("classes")) return true;
  }
  return false;
}

std::vector<ClassRow> class_rows(const Json& kernel) {
  std::vector<ClassRow> rows;
  for (const InputClass which : enumerators<InputClass>) {
    ClassRow row{which, 0, 0, 0, "", ""};
    for (const auto& [family, result] : kernel["families"].items()) {
      const Json classes = result.value("classes", Json::object());
      const auto found = classes.find(std::string(input_class_names[which]));
      if (found == classes.end()) continue;
      row.missed += (*found)["false_separation"].get<std::uint64_t>();
      row.phantom += (*found)["false_contact"].get<std::uint64_t>();
      const double deepest = (*found)["deepest"];
      if (row.witness.empty() || deepest > row.deepest) {
        row.deepest = deepest;
        row.family = family;
        row.witness = (*found)["witness"];
      }
    }
    if (row.missed + row.phantom != 0) rows.push_back(row);
  }
  return rows;
}

std::string nearest_sentence(const Json& kernel) {
  const Json nearest = kernel.value("nearest", Json());
  if (nearest.is_null()) return "";
  const auto count = [&](const char* member) { return nearest[member].get<std::uint64_t>(); };
  const std::uint64_t both = count("both"), either = count("either");
  return fmt::format(
      "{}{}, wrong on {} % of the queries on which either is ({} of {}, among {}: the first {} of each family and the "
      "deepest)",
      2 * both >= either ? "Nearest of the built-in kernels: " : "No built-in kernel fails alike; the nearest is ",
      nearest["kernel"].get<std::string>(), amount(100 * static_cast<double>(both) / static_cast<double>(either), 3),
      thousands(both), thousands(either), thousands(count("queries")), thousands(nearest_queries));
}

Json classes_data(const Json& kernel) {
  if (!has_classes(kernel)) return nullptr;
  Json rows = Json::array();
  for (const ClassRow& row : class_rows(kernel)) {
    rows.push_back({{"class", input_class_names[row.which]},
                    {"meaning", class_meanings[row.which]},
                    {"missed", row.missed},
                    {"phantom", row.phantom},
                    {"deepest", row.deepest},
                    {"family", row.family},
                    {"witness", row.witness}});
  }
  return {{"rows", std::move(rows)}, {"nearest", nearest_sentence(kernel)}};
}

}  // namespace axiscert
