// The plan of a run as its record states it.
#pragma once

#include "fuzz/campaign/campaign.h"
#include "fuzz/files/json.h"

namespace axiscert {

// `require` is the level as given, or empty. Of the result it is the cells' units and queries that count.
Json plan_json(const Plan& plan, const CampaignResult& result, const std::string& require);

}  // namespace axiscert
