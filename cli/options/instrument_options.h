// What the measuring subcommands share: which kernels on which queries, and where their report goes.
#pragma once

#include "cli/commands.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

struct InstrumentOptions {
  std::vector<std::string> kernels, families;  // as given; the subcommand's defaults where empty
  std::uint64_t trials = 0, seed = 1;
  std::string precision = "binary32", format = "text", out;
};

// Adds --kernel, --family, --trials, --seed, --precision, --format text|json and --out; `trials` is the default.
void add_instrument_options(CLI::App& command, InstrumentOptions& options, std::uint64_t trials);

// Whether an instrument asks verdicts alone, or looks into formulae that only a built-in kernel is known to evaluate.
enum class Measures { verdicts, formulae };
// The kernels asked for, or `defaults`. Throws Error for one that does not exist in the precision, or that the
// instrument is not for.
std::vector<const Kernel*> instrument_kernels(const InstrumentOptions& options, std::vector<std::string> defaults,
                                              Measures measures);
// The families asked for, or `defaults`.
std::vector<SourcePtr> instrument_sources(const InstrumentOptions& options, std::vector<std::string> defaults);
// The command line that makes the report again: "axiscert NAME --kernel ...".
std::string instrument_command(const std::string& name, const InstrumentOptions& options);

// Prints the report in the format asked for and, where --out names a folder, writes NAME.json and NAME.html there.
int put_instrument(const InstrumentReport& report, const InstrumentOptions& options);

}  // namespace axiscert
