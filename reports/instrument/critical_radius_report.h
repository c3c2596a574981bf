// The report of `axiscert critical-radius`.
#pragma once

#include "fuzz/instruments/critical_radius.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

InstrumentReport critical_radius_report(const CriticalRadiusPlan& plan, const CriticalRadiusResult& result,
                                        const std::string& command);

}  // namespace axiscert
