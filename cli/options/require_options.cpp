#include "cli/options/run_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/usage.h"
#include "fuzz/text/length_unit.h"
#include "kernel/base/error.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

// Any kernel meets a depth beyond the greatest; a record that requires one is read all the same.
void require_depth_that_occurs(const AskedLevel& asked, const Predicate& predicate) {
  const GateLevel& level = level_of(asked);
  if (!asked.has_argument || level.allowed == nullptr) return;
  const AllowedDepths allowed = level.allowed(asked);
  if (allowed.are_lengths || !(allowed.phantom > predicate.greatest_depth)) return;
  const bool is_optional = std::string_view(level.usage).find('[') != std::string_view::npos;
  throw Error(fmt::format(
      "--require {}: D is a depth, a share of the scene from 0 to {} in a predicate of {}, as in {}=0.001{}",
      asked.text, predicate.greatest_depth, predicate.id, asked.name,
      is_optional ? fmt::format("; `{}` alone sets no limit", asked.name) : ""));
}

}  // namespace

void add_require_options(CLI::App& command, RunRequirements& required) {
  const std::vector<std::string_view> names = length_unit_names();
  command
      .add_option(
          "--require", required.levels,
          fmt::format("LEVEL or 'LEVEL in FAMILY,...' (patterns with * too), repeatable: exit 1 where it is not met "
                      "or not checked; {}",
                      levels_help()))
      ->allow_extra_args(false);
  command
      .add_option("--allow-unchecked", required.allow_unchecked,
                  "level of --require that passes where these queries or this kernel cannot show it, repeatable")
      ->allow_extra_args(false);
  command
      .add_option(
          "--unit", required.unit,
          "the unit of length of the queries' numbers, for lengths in levels and reports (families of scenes are "
          "in metres)")
      ->check(one_of({names.begin(), names.end()}));
}

void check_required(const RunRequirements& required, const Plan& plan) {
  const PlanRecord stated = plan_record(plan, CampaignResult(), required);
  const Requirements requirements = requirements_of(stated);
  for (const AskedLevel& asked : requirements.levels) require_depth_that_occurs(asked, plan.questions.predicate());
  for (const std::string& id : yardsticks_of(stated)) {
    const bool is_run = std::any_of(plan.answerers.kernels.begin(), plan.answerers.kernels.end(),
                                    [&](const Kernel* kernel) { return kernel->id == id; });
    if (is_run) continue;
    throw Error(fmt::format("--require no-worse-than={}: {}", id,
                            plan.answerers.replies
                                ? "replies are of one program; only `run` judges two kernels on the same queries"
                                : fmt::format("that kernel is not in this run; add --kernel {}", id)));
  }
}

}  // namespace axiscert
