// The report of `axiscert precision`.
#pragma once

#include "fuzz/sphere_triangle/formulae/precision.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// `tallies` by source; `command` produces them again.
InstrumentReport precision_report(const PrecisionPlan& plan, const std::vector<PrecisionTally>& tallies,
                                  const std::string& command);

}  // namespace axiscert
