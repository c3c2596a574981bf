// Checks of option values, for CLI11: their messages say what was given and what would be right.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace axiscert {

// A number in digits, from `least` to `most`. "1e6" or "2^20" is told how it is written; CLI11 alone would take "-1"
// for the greatest number there is, and any number beyond for it too.
CLI::Validator whole_number(std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

CLI::Validator number_above_zero();
// From `least` to `most`, both included.
CLI::Validator number_between(double least, double most);

// One of these words; a near miss is told which.
CLI::Validator one_of(std::vector<std::string> words);

}  // namespace axiscert
