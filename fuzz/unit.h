// One unit: 2^16 queries of one source and precision, generated, answered by every kernel, judged and tallied.
#pragma once

#include "fuzz/campaign.h"

namespace axiscert {

struct UnitResult {
  std::vector<Tally> tallies;  // by kernel
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
};

// The first `size` queries of unit `number`. Depends on its arguments only, but for core_seconds.
UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size);

}  // namespace axiscert
