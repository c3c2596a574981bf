// Functions that several subcommands use.
#include "cli/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>
#include <vector>

#include "cli/ending.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "exact/judge/judge.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/base/version.h"
#include "kernel/plugin/supervisor.h"
#include "reports/formats/schemas.h"

namespace axiscert {

CLI::Option* add_format(CLI::App& command, std::string& format, const std::vector<std::string>& machine_formats) {
  std::vector<std::string> words = {"text"};
  words.insert(words.end(), machine_formats.begin(), machine_formats.end());
  return command
      .add_option("--format", format, fmt::format("text, or {} for programs", fmt::join(machine_formats, " or ")))
      ->check(one_of(words))
      ->capture_default_str()
      ->group(output_group);
}

std::string data_text(const Json& data, const std::string& format) {
  return format == "csv" ? csv_of(data) : data.dump(2) + "\n";
}

int print_failure(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const HarnessFault& fault) {
    fmt::print(stderr, "axiscert: {}\n", fault.what());
    return exit_harness_fault;
  } catch (const Unwritable& unwritable) {
    fmt::print(stderr, "axiscert: {}\n", unwritable.what());
    print_how_to_go_on();
  } catch (const Error& error) {
    fmt::print(stderr, "axiscert: {}\n", error.what());
    print_what_is_kept();
  } catch (const std::system_error& refused) {  // by the system: a pipe, a folder, a thread
    fmt::print(stderr, "axiscert: {}\n", printable_line(refused.what()));
    print_how_to_go_on();
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "axiscert: there is not enough memory; with fewer --threads it needs less\n");
    print_how_to_go_on();
  } catch (const std::exception& unexpected) {
    fmt::print(stderr, "axiscert: unexpected: {}\n", printable_line(unexpected.what()));
    return exit_harness_fault;
  }
  return exit_bad_input;
}

void add_plugin_seconds(CLI::App& command) {
  command
      .add_option(
          "--plugin-seconds", plugin::batch_seconds,
          "processor time that a plug-in or program may take for a batch of 1024 queries before it counts as hung")
      ->check(number_between(1e-3, 1e6))
      ->capture_default_str()
      ->group(running_group);
}

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
