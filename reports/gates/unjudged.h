// The part of a plan that a run did not judge. A run in which there is anything of it never exits with 0, whatever was
// required of it.
#pragma once

#include <string>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

// Sentences, one for each kernel of the plan that could not be loaded, that has a family without a valid query in any
// of its precisions, or that has valid queries outside its limits only. Empty where the whole plan was judged.
std::vector<std::string> unjudged(const Record& record);

}  // namespace axiscert
