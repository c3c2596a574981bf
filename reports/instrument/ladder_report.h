// The report of `axiscert ladder`.
#pragma once

#include "fuzz/instruments/ladder.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// Tables, plots, notes and the figures as JSON. `command` makes it again.
InstrumentReport ladder_report(const LadderPlan& plan, const std::vector<LadderEntry>& entries,
                               const std::string& command);
// The figures alone; every time is in the member "speed", which is not there where none was taken.
Json ladder_json(const LadderPlan& plan, const std::vector<LadderEntry>& entries);

}  // namespace axiscert
