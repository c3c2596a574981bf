// Declares the options that the measuring subcommands share (plans/instrument_plan.h), and prints their
// reports.
#pragma once

#include "cli/commands.h"
#include "reports/instrument/instrument.h"
#include "plans/instrument_plan.h"

namespace axiscert {

// Adds the kernels, --family, --trials, --seed, --precision, --threads, --progress, --format text|json|csv and --out;
// `trials` is the default.
void add_instrument_options(CLI::App& command, InstrumentOptions& options, std::uint64_t trials);

// Adds --mesh, --queries, --corpus and --sweep.
void add_own_queries(CLI::App& command, InstrumentOptions& options);

// Before anything runs: creates the folder of --out, and says what asks less, for an interrupt: the figures are of all
// queries or of none. Throws Error where nothing can be written there.
void begin_instrument(const InstrumentOptions& options);

// Prints the report in the given format and, where --out names a folder, writes NAME.json, NAME.csv and NAME.html
// there.
int print_and_write_instrument(const InstrumentReport& report, const InstrumentOptions& options);

}  // namespace axiscert
