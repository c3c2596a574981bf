// Functions that several subcommands use.
#include "cli/commands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

#include "cli/ending.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "exact/judge/judge.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
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

}  // namespace axiscert
