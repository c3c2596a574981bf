// axiscert: judges collision tests beside exact arithmetic.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/ending.h"
#include "cli/usage.h"
#include "fuzz/files/query_file.h"
#include "kernel/base/version.h"

int main(int argc, char** argv) {
  using namespace axiscert;
  // Each plug-in at work on a thread is a process with a socket and a memory file.
  if (rlimit files{}; getrlimit(RLIMIT_NOFILE, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    setrlimit(RLIMIT_NOFILE, &files);
  }
  CLI::App app{
      "Runs collision tests beside exact arithmetic and reports where, how far, how often and why they are wrong. "
      "`axiscert explain WORD` says what a word of its output means."};
  app.set_version_flag("--version", fmt::format("axiscert {} (revision {})", axiscert_version, axiscert_revision));
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 a requirement failed; 2 bad usage or input, a target this machine lacks, a full disk;\n"
      "3 the oracles disagree, or the harness found a fault in itself; 130 interrupted, 143 by SIGTERM.");
  set_query_notes([](const std::string& note) { fmt::print(stderr, "axiscert: {}\n", note); });
  Action action;
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
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  begin_command(words);
  try {
    app.parse(argc, argv);
    require_values(app, words);
    const int code = action();
    finish_output();
    if (code == exit_interrupted || code == exit_terminated) print_how_to_go_on();
    return code;
  } catch (const CLI::ParseError& usage) {
    return print_usage(app, usage, words);
  } catch (...) {
    return print_failure(std::current_exception());
  }
}
