#include "reports/run_folder/record_classes.h"

#include <fmt/format.h>

namespace axiscert {
namespace {

std::uint64_t number_of(const Json& count) { return count.get<std::uint64_t>(); }

std::uint64_t sum_of(const Json& decades) {
  std::uint64_t sum = 0;
  for (const Json& count : decades) sum += number_of(count);
  return sum;
}

}  // namespace

std::optional<std::string> fault_of_classes(const Json& kernel, const Json& family) {
  const auto classes = family.find("classes");
  if (classes == family.end()) return std::nullopt;
  if (kernel["reference"] == true) return "classes of a kernel with a reference, whose links say why it is wrong";
  const Json& verdict = family["verdict"];
  for (const char* kind : {"false_separation", "false_contact"}) {
    std::uint64_t sum = 0;
    for (const auto& [name, of] : classes->items()) sum += number_of(of[kind]);
    if (sum != number_of(verdict[kind])) {
      return fmt::format("the classes have {} {} verdicts, but the family {}", sum, kind, number_of(verdict[kind]));
    }
  }
  std::uint64_t ties = 0;
  for (const auto& [name, of] : classes->items()) {
    const std::uint64_t wrong = number_of(of["false_separation"]) + number_of(of["false_contact"]);
    if (wrong == 0) return fmt::format("class {} has no wrong verdict", name);
    if (of["deepest"].get<double>() > verdict["deepest"].get<double>()) {
      return fmt::format("the deepest of class {} is deeper than the deepest of the family", name);
    }
    if (name == "tie") ties = wrong;
  }
  if (ties != number_of(verdict["touching_flips"])) return "class tie and touching_flips do not agree";
  return std::nullopt;
}

// Records of earlier versions have neither.
std::optional<std::string> fault_of_depths(const Json& verdict, std::uint64_t valid) {
  const Json depths = verdict.value("depths", Json()), engine = verdict.value("engine_like", Json());
  for (const char* kind : {"false_separation", "false_contact"}) {
    if (!depths.is_null() && sum_of(depths[kind]) != number_of(verdict[kind]))
      return fmt::format("depths do not add up to {}", kind);
    if (engine.is_null()) continue;
    if (sum_of(engine["depths"][kind]) != number_of(engine[kind]))
      return fmt::format("depths on engine-like queries do not add up to their {}", kind);
    if (number_of(engine[kind]) > number_of(verdict[kind]))
      return fmt::format("more {} on engine-like queries than on all", kind);
  }
  if (!engine.is_null() && number_of(engine["queries"]) > valid) return "more engine-like queries than valid ones";
  return std::nullopt;
}

}  // namespace axiscert
