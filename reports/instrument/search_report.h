// The report of `axiscert search`.
#pragma once

#include "fuzz/search/search.h"
#include "reports/instrument/instrument.h"

namespace axiscert {

InstrumentReport search_report(const SearchPlan& plan, const SearchResult& result, const std::string& command);
// All queries that the search looked at: those that were evaluated, and those of the run before. Where none of them was
// decided, it says nothing about the kernel.
LookedAt search_looked_at(const SearchResult& result);
// The witnesses as a query file, one for each find.
std::string search_witnesses(const SearchResult& result);

}  // namespace axiscert
