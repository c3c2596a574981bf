#include "reports/run_folder/record_classes.h"

#include <fmt/format.h>

namespace axiscert {

std::optional<std::string> fault_of_classes(const Json& kernel, const Json& family) {
  const auto classes = family.find("classes");
  if (classes == family.end()) return std::nullopt;
  if (kernel["reference"] == true) return "classes of a kernel with a reference, whose links say why it is wrong";
  const auto number = [](const Json& count) { return count.get<std::uint64_t>(); };
  const Json& verdict = family["verdict"];
  for (const char* kind : {"false_separation", "false_contact"}) {
    std::uint64_t sum = 0;
    for (const auto& [name, of] : classes->items()) sum += number(of[kind]);
    if (sum != number(verdict[kind])) {
      return fmt::format("the classes have {} {} verdicts, but the family {}", sum, kind, number(verdict[kind]));
    }
  }
  std::uint64_t ties = 0;
  for (const auto& [name, of] : classes->items()) {
    const std::uint64_t wrong = number(of["false_separation"]) + number(of["false_contact"]);
    if (wrong == 0) return fmt::format("class {} has no wrong verdict", name);
    if (of["deepest"].get<double>() > verdict["deepest"].get<double>()) {
      return fmt::format("the deepest of class {} is deeper than the deepest of the family", name);
    }
    if (name == "tie") ties = wrong;
  }
  if (ties != number(verdict["touching_flips"])) return "class tie and touching_flips do not agree";
  return std::nullopt;
}

}  // namespace axiscert
