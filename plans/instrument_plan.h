// What the measuring commands share: the kernels and the queries that are asked for, by names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plans/predicate_options.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

struct InstrumentOptions {
  std::string command;                                 // its name, for messages
  std::vector<std::string> kernels, families;          // as given; empty: the subcommand's defaults
  std::vector<std::string> queries = {}, meshes = {};  // files, of a subcommand that takes them
  std::optional<std::string> corpus = {};              // its folder
  std::string sweep = {};                              // PARAMETER=VALUES; empty: nothing is swept
  std::uint64_t trials = 0, seed = 1;
  std::string precision = "binary32", format = "text", out;
  int threads = 0;             // 0: all cores
  std::string asks_less = {};  // besides fewer queries, kernels and families: "--no-speed measures no times"
};

// An instrument uses the verdicts of a kernel; its comparisons, which it holds to formulae that the kernel
// claims; or the formulae alone, which it evaluates itself.
enum class Measures { verdicts, comparisons, formulae };
// The kernels given by the options, or `defaults`. Throws Error for one that does not exist in the precision, that the
// instrument does not accept, or of a predicate that is none of `served`.
std::vector<const Kernel*> instrument_kernels(
    const InstrumentOptions& options, std::vector<std::string> defaults, Measures measures,
    const std::vector<const Predicate*>& served = predicates_with(has_formulae));
// The predicate and the entry of the kernels or the families that are given; the first where neither are.
struct EntryAsked {
  const Predicate* predicate;
  std::size_t entry;
};
EntryAsked entry_asked(const InstrumentOptions& options);
// The families and files given by the options, or `defaults`, and each of these with each value of a swept parameter.
// Throws Error for one of a predicate that is none of `served`, and for a file without a valid query.
std::vector<SourcePtr> instrument_sources(const InstrumentOptions& options, std::vector<std::string> defaults,
                                          const std::vector<const Predicate*>& served = predicates_with(has_formulae));
// The command line that produces the report again: "axiscert NAME --kernel ...".
std::string instrument_command(const std::string& name, const InstrumentOptions& options);

}  // namespace axiscert
