// The report of `axiscert search`.
#pragma once

#include "fuzz/hunt/search.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

inline constexpr const char* search_schema = "axiscert-search/1";

InstrumentReport search_report(const HuntPlan& plan, const HuntResult& result, const std::string& command);
// The witnesses as a query file, one a find.
std::string search_witnesses(const HuntResult& result);

}  // namespace axiscert
