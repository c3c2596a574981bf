// One unit of a test without filters: every query is judged by the test's oracles (exact/trait/oracles.h).
#pragma once

#include "fuzz/campaign/unit.h"

namespace axiscert {

// As run_unit, for queries `first` to first + size - 1. No limits, critical radii or margins, which are
// sphere-triangle's. A kernel that takes another entry than the source gives is not asked.
void run_plain_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t first,
                    std::uint64_t size, const std::vector<Standing>& standing, UnitResult& out);

}  // namespace axiscert
