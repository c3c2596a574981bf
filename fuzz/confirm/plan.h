// The plan of a run as its record states it.
#pragma once

#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/record/plan_record.h"

namespace axiscert {

// The requirements of a run, as they were given: levels, and those of them that may be left unchecked.
struct RunRequirements {
  std::vector<std::string> levels = {}, allow_unchecked = {};
};

// Only the cells' units and queries of the result are used.
PlanRecord plan_record(const Plan& plan, const CampaignResult& result, const RunRequirements& required);
// The same of a plan that is done whole.
PlanRecord plan_record(const Plan& plan, const RunRequirements& required = {});

}  // namespace axiscert
