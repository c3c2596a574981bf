// One unit: 2^16 queries of one source and precision, generated, answered by every kernel, judged and tallied.
#pragma once

#include "fuzz/campaign.h"

namespace axiscert {

struct UnitResult {
  std::vector<Tally> tallies;  // by kernel
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;
};

// The first `size` queries of unit `number`. What other units of the cell have found, by kernel, saves evaluating what
// can be no maximum; it may be empty. Merged with their tallies the result depends on the other arguments only, but for
// the times.
UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<Standing>& standing = {});

}  // namespace axiscert
