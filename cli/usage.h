// Wrong command lines: what was given, where, and what would be right, in one line. CLI11's own messages name neither
// the nearest option nor the values of one that is repeated.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace axiscert {
// "axiscert corpus add".
std::string full_name(const CLI::App& command);

// The message for a command line, of these words after the program's name, that the parser refused.
std::string usage_message(const CLI::App& app, const CLI::ParseError& refused, const std::vector<std::string>& words);

// Prints the message on standard error, or what --help and --version show on standard output. Returns an ExitCode.
int print_usage(const CLI::App& app, const CLI::ParseError& refused, const std::vector<std::string>& words);

// Throws CLI::ParseError where a value is empty, of spaces alone, or the name of another option: CLI11 takes `--kernel
// --quiet` for a kernel, and `--key ''` would be no key.
void require_values(const CLI::App& app, const std::vector<std::string>& words);

// Checks of option values, for CLI11: their messages say what was given and what would be right.

// A number in digits, from `least` to `most`. "1e6" or "2^20" is told how it is written; CLI11 alone would take "-1"
// for the greatest number there is, and any number beyond for it too.
CLI::Validator whole_number(std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

CLI::Validator number_above_zero();
// From `least` to `most`, both included.
CLI::Validator number_between(double least, double most);

// One of these words; a near miss is told which.
CLI::Validator one_of(std::vector<std::string> words);

}  // namespace axiscert
