// The report of `axiscert condition`.
#pragma once

#include "fuzz/sphere_triangle/formulae/condition.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

InstrumentReport condition_report(const ConditionPlan& plan, const ConditionResult& result, const std::string& command);

}  // namespace axiscert
