#include "cli/app.h"

#include <fmt/format.h>

#include <vector>

#include "cli/help.h"
#include "kernel/base/version.h"

namespace axiscert {

void declare_command_line(CLI::App& app, Action& action) {
  app.formatter(std::make_shared<Help>());
  app.description(
      "Runs collision tests beside exact arithmetic and reports where, how far, how often and why they are wrong. "
      "`axiscert explain WORD` says what a word of its output means, `axiscert COMMAND --help` what a command takes.");
  app.set_version_flag("--version", fmt::format("axiscert {} (revision {})", axiscert_version, axiscert_revision));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 a requirement failed; 2 bad usage or input, a target this machine lacks, a full disk; 3 "
      "the "
      "oracles disagree, or the harness found a fault in itself; 130 interrupted, 143 by SIGTERM.");
  // Each subcommand, under what its user wants; `man` stays hidden.
  struct Purpose {
    const char* name;
    std::vector<void (*)(CLI::App&, Action&)> adders;
  };
  for (const Purpose& purpose : {
           Purpose{"Judge a kernel",
                   {add_run, add_certify, add_verify, add_check, add_report, add_diagnose, add_shrink, add_search,
                    add_map, add_generate, add_judge}},
           Purpose{"Use the right one", {add_league, add_kernels, add_predicates}},
           Purpose{"Keep it right in CI", {add_compare, add_corpus, add_plan, add_merge}},
           Purpose{"Study precision",
                   {add_ladder, add_precision, add_condition, add_critical_radius, add_mutate, add_prove}},
           Purpose{"Look up", {add_explain, add_families, add_query, add_completion}},
       }) {
    for (const auto add : purpose.adders) {
      add(app, action);
      app.get_subcommands({}).back()->group(purpose.name);
    }
  }
  add_man(app, action);
}

}  // namespace axiscert
