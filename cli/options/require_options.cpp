#include "cli/options/require_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "kernel/base/error.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

// A depth beyond the scene is met by any kernel; a record that has one is read all the same.
std::string depth_is_a_part(const std::string& level) {
  const std::size_t equals = level.find('=');
  const std::string name = level.substr(0, equals);
  double depth = 0;
  if (equals == level.npos || (name != "conservative" && name != "depth") ||
      !CLI::detail::lexical_cast(level.substr(equals + 1), depth) || !(depth > 1))
    return "";
  return fmt::format("'{}': D is a depth, a share of the scene from 0 to 1, as in {}=0.001{}", level, name,
                     name == "depth" ? "" : "; `conservative` alone sets no limit");
}

}  // namespace

void add_require_options(CLI::App& command, Required& required) {
  command
      .add_option("--require", required.levels,
                  fmt::format("level, repeatable: exit 1 where it is not met or not checked; {}", levels_help()))
      ->allow_extra_args(false)
      ->check(depth_is_a_part);
  command
      .add_option("--allow-unchecked", required.allow_unchecked,
                  "level of --require that passes where these queries or this kernel cannot show it, repeatable")
      ->allow_extra_args(false);
}

void check_required(const Required& required, const Plan& plan) {
  const Json stated = plan_json(plan, CampaignResult(), required);
  requirements_of(stated);
  for (const std::string& id : yardsticks_of(stated)) {
    const bool is_run =
        std::any_of(plan.kernels.begin(), plan.kernels.end(), [&](const Kernel* kernel) { return kernel->id == id; });
    if (is_run) continue;
    throw Error(fmt::format("--require no-worse-than={}: {}", id,
                            plan.replies
                                ? "replies are of one program; only `run` judges two kernels on the same queries"
                                : fmt::format("that kernel is not in this run; add --kernel {}", id)));
  }
}

}  // namespace axiscert
