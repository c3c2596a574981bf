// The report of `axiscert critical-radius`.
#pragma once

#include "fuzz/instruments/critical_radius.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

// Each kernel of which no triangle was measured, with the reasons.
std::vector<std::string> unmeasured_kernels(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result);

InstrumentReport critical_radius_report(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result,
                                        const std::string& command);

}  // namespace axiscert
