// The subcommands of `axiscert`, one file each. Each adds itself to the parser and sets `action` when it is chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/text/json_fwd.h"

namespace axiscert {

enum ExitCode {
  exit_done = 0,
  exit_requirement_failed = 1,  // or something that was to be judged or compared was not
  exit_bad_input = 2,
  exit_harness_fault = 3,
  exit_interrupted = 130,
  exit_terminated = 143
};

// Runs the chosen subcommand and returns an ExitCode. Throws Error and HarnessFault.
using Action = std::function<int()>;

void add_run(CLI::App& app, Action& action);
void add_plan(CLI::App& app, Action& action);
void add_merge(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_shrink(CLI::App& app, Action& action);
void add_corpus(CLI::App& app, Action& action);
void add_query(CLI::App& app, Action& action);
void add_kernels(CLI::App& app, Action& action);
void add_predicates(CLI::App& app, Action& action);
void add_families(CLI::App& app, Action& action);
void add_certify(CLI::App& app, Action& action);
void add_verify(CLI::App& app, Action& action);
void add_report(CLI::App& app, Action& action);
void add_ladder(CLI::App& app, Action& action);
void add_precision(CLI::App& app, Action& action);
void add_condition(CLI::App& app, Action& action);
void add_critical_radius(CLI::App& app, Action& action);
void add_diagnose(CLI::App& app, Action& action);
void add_league(CLI::App& app, Action& action);
void add_map(CLI::App& app, Action& action);
void add_search(CLI::App& app, Action& action);
void add_prove(CLI::App& app, Action& action);
void add_mutate(CLI::App& app, Action& action);
void add_generate(CLI::App& app, Action& action);
void add_judge(CLI::App& app, Action& action);
void add_compare(CLI::App& app, Action& action);
void add_explain(CLI::App& app, Action& action);
void add_completion(CLI::App& app, Action& action);
void add_man(CLI::App& app, Action& action);

// Prints on standard error what an action threw, and returns its ExitCode.
int print_failure(const std::exception_ptr& thrown);

// Adds the `--format` option of the commands that also write for programs: text, or one of `machine_formats`.
CLI::Option* add_format(CLI::App& command, std::string& format, const std::vector<std::string>& machine_formats);
// Those of the instruments and lists, whose data docs/data.md describes.
inline const std::vector<std::string> data_formats = {"json", "csv"};
// The data in one of these formats, as it is printed.
std::string data_text(const Json& data, const std::string& format);
// Adds the `--plugin-seconds` option of the commands that run kernels.
void add_plugin_seconds(CLI::App& command);

// The whole command line: its subcommands, under what their users want, and what it says of itself.

// Declares every subcommand; `action` is the chosen one's, once a line is parsed.
void declare_command_line(CLI::App& app, Action& action);

}  // namespace axiscert
