// The whole command line: its subcommands, under what their users want, and what it says of itself.
#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace axiscert {

// Declares every subcommand; `action` is the chosen one's, once a line is parsed.
void declare_command_line(CLI::App& app, Action& action);

}  // namespace axiscert
