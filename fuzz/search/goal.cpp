#include "fuzz/search/goal.h"

#include <fmt/format.h>

#include <algorithm>

#include "exact/trait/oracles.h"

namespace axiscert {

std::string name(const Aim& aim) {
  const auto goal = goal_names[aim.goal];
  return is_about_a_comparison(aim.goal) ? fmt::format("{} {}", goal, info(aim.which).name) : std::string(goal);
}

std::vector<Aim> aims_of(const Kernel& kernel, const std::vector<Comparison>& only) {
  std::vector<Aim> aims;
  if (kernel.test != &first_test()) {
    if (oracles_of(kernel).has_depth()) aims = {{Goal::missed_contact}, {Goal::phantom_contact}};
    return aims;
  }
  if (kernel.exposes == Exposure::sides && has_comparisons(kernel.formulae)) {
    for (const Goal goal : {Goal::error, Goal::relative_error, Goal::overflow, Goal::underflow}) {
      for (std::size_t k = 0; k < comparison_count; ++k) {
        const auto which = static_cast<Comparison>(k);
        if (only.empty() || std::find(only.begin(), only.end(), which) != only.end()) aims.push_back({goal, which});
      }
    }
  }
  if (only.empty()) {
    for (const Goal goal : {Goal::missed_contact, Goal::phantom_contact, Goal::critical_radius}) aims.push_back({goal});
  }
  return aims;
}

}  // namespace axiscert
