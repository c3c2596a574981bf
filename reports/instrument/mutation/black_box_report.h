// The report of `axiscert mutate --verdict-only`.
#pragma once

#include <string>
#include <vector>

#include "fuzz/mutation/black_box.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// Answers that a gate that is right would not give: it refused a kernel that is right, or a mutant that nothing
// distinguishes from one. Empty if there is none.
std::vector<std::string> black_box_faults(const BlackBoxScore& score);

InstrumentReport black_box_report(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                                  const std::string& command);

// The figures of the report.
Json black_box_json(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                    const std::string& command);

}  // namespace axiscert
