// The report of `axiscert mutate`.
#pragma once

#include "fuzz/mutation/mutation.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// Faults of the harness, or of an argument for equivalence; empty if there are none.
std::vector<std::string> mutation_faults(const MutationResult& result, const std::vector<Control>& controls);

// `whole`: include a row for each mutant.
InstrumentReport mutation_report(const MutationPlan& plan, const MutationResult& result,
                                 const std::vector<Control>& controls, const std::string& command, bool whole);
std::string instrument_markdown(const InstrumentReport& report);

}  // namespace axiscert
