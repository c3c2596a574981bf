// The levels with which a report begins.
#pragma once

#include <string>
#include <vector>

#include "reports/gates/requirement.h"

namespace axiscert {

struct FirstLevels {
  bool are_required;  // else they are those that are advised
  std::string lead;   // a sentence
  std::vector<LevelOutcome> outcomes;
};
FirstLevels first_levels(const Record& record);

// Where it is not met, the first way; why it is not checked; empty where it is met.
std::string reason_text(const LevelOutcome& outcome);

}  // namespace axiscert
