// The record: the deterministic result of a run, and run.json, which holds what varies.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.h"
#include "fuzz/files/json.h"

namespace axiscert {

inline constexpr const char* record_schema = "axiscert-record/1";

// record.json: no clock, host, thread count, target or compiler in it. `require` is the level as given, or empty.
// Makes the witnesses' queries again and examines each by all oracles.
Json record_of(const Plan& plan, const CampaignResult& result, const std::string& require);

// run.json: times, throughput, machine, target, compiler and library versions. `started` is ISO 8601, UTC.
Json run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
              const std::string& started, double seconds);

// A query as the query file has it: "a" to "p" as arrays of hex strings, "r".
template <class Real>
void put_query(Json& into, const Query<Real>& q);
// What a kernel shows: "verdict", and "comparisons" and "sides" where it does.
Json exposures_json(const Kernel& kernel);
// The limits that a kernel declares, null where it has none; null for each that it does not set.
Json limits_json(const Limits& limits);
// "verdict", ... as `check` and the witnesses list them.
Json flips_json(const Judgement& judgement);

}  // namespace axiscert
