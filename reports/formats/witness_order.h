// The witnesses of report.html, and the order in which it lists them.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

// The witnesses that the page shows, at most `limit`: one for each cause of a wrong verdict (each kernel, precision,
// direction, set of broken links and class of the input), the shortest ordinary one where there is one; those that are
// named, by their ids, the deepest, and for each kernel, precision, family and place of a flip one that shows it. The
// causes come first, then the other wrong verdicts, then those that were kept for another reason; in each of the three
// ordinary queries before others, and deeper verdicts before less deep ones.
std::vector<const WitnessRecord*> shown_witnesses(const Record& record, std::size_t limit,
                                                  const std::set<std::string>& named = {});

// Whether a scene could ask it: every number is zero or normal and at most 2^20, and a length that is not zero is at
// least 2^-20: from a micrometre to a thousand kilometres where the unit is a metre.
bool is_ordinary(const WitnessRecord& witness, const PlanRecord& plan);

}  // namespace axiscert
