// Wrong command lines: what was given, where, and what would be right, in one line. CLI11's own messages name neither
// the nearest option nor the values of one that is repeated.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace axiscert {

// The message for a command line that the parser refused.
std::string usage_message(const CLI::App& app, const CLI::ParseError& refused);

// Prints the message on standard error, or what --help and --version show on standard output. Returns an ExitCode.
int tell_usage(const CLI::App& app, const CLI::ParseError& refused);

// Throws Error where the value of an option is the name of another: CLI11 takes `--kernel --quiet` for a kernel.
void require_values(const CLI::App& app);

}  // namespace axiscert
