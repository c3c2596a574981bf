// The plan of a run as its record states it.
#pragma once

#include "fuzz/campaign/campaign.h"
#include "fuzz/text/json.h"

namespace axiscert {

// `require` is the level as given, or empty. Only the cells' units and queries of the result are used.
Json plan_json(const Plan& plan, const CampaignResult& result, const std::string& require);

}  // namespace axiscert
