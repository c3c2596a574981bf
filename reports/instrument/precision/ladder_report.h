// The report of `axiscert ladder`.
#pragma once

#include "fuzz/sphere_triangle/formulae/ladder.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// Tables, plots, notes and the figures as JSON. `command` produces the report again.
InstrumentReport ladder_report(const LadderPlan& plan, const std::vector<LadderEntry>& entries,
                               const std::string& command);
// The figures alone; all times are in the member "speed", which is absent where none were taken.
Json ladder_json(const LadderPlan& plan, const std::vector<LadderEntry>& entries, const std::string& command);

}  // namespace axiscert
