#include "cli/options/run_options.h"

#include <fmt/format.h>

#include "cli/usage.h"
#include "fuzz/text/number_text.h"
#include "reports/gates/requirement.h"

namespace axiscert {
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

}  // namespace axiscert
