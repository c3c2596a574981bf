// axiscert: certifies floating-point sphere-triangle kernels against exact arithmetic.
#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>

#include "cli/commands.h"
#include "exact/truth.h"
#include "kernel/error.h"
#include "kernel/plugin/supervisor.h"

namespace axiscert {

CLI::Option* add_format(CLI::App& command, std::string& format, const std::string& machine_format) {
  return command.add_option("--format", format, "text, or " + machine_format + " for programs")
      ->check(CLI::IsMember({std::string("text"), machine_format}))
      ->capture_default_str();
}

int tell(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const HarnessFault& fault) {
    fmt::print(stderr, "axiscert: {}\n", fault.what());
    return exit_harness_fault;
  } catch (const Error& error) {
    fmt::print(stderr, "axiscert: {}\n", error.what());
    return exit_bad_input;
  } catch (const std::exception& unexpected) {
    fmt::print(stderr, "axiscert: unexpected: {}\n", unexpected.what());
    return exit_harness_fault;
  }
}

void add_plugin_seconds(CLI::App& command) {
  command
      .add_option("--plugin-seconds", plugin::batch_seconds,
                  "processor time that a plug-in may take for a batch of 1024 queries before it counts as hung")
      ->check(CLI::Range(1e-3, 1e6))
      ->capture_default_str();
}

}  // namespace axiscert

int main(int argc, char** argv) {
  using namespace axiscert;
  // Every plug-in at work on a thread is a process with a socket and a memory file.
  if (rlimit files{}; getrlimit(RLIMIT_NOFILE, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    setrlimit(RLIMIT_NOFILE, &files);
  }
  CLI::App app{
      "Runs sphere-triangle kernels beside exact arithmetic and reports where, how far and how often they are wrong."};
  app.set_version_flag("--version", "axiscert " AXISCERT_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done; 1 a requirement failed; 2 bad usage or input, or a target this machine lacks;\n"
      "3 the oracles disagree, or the harness caught itself wrong; 130 interrupted.");
  Action action;
  for (const auto add : {
           add_run,       add_plan,      add_merge,           add_check,  add_shrink,  add_corpus,
           add_query,     add_kernels,   add_families,        add_report, add_compare, add_ladder,
           add_precision, add_condition, add_critical_radius, add_league, add_search,  add_map,
           add_mutate,    add_prove,     add_generate,        add_judge,  add_man,
       })
    add(app, action);
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::ParseError& usage) {
    return app.exit(usage) == 0 ? exit_done : exit_bad_input;
  } catch (...) {
    return tell(std::current_exception());
  }
}
