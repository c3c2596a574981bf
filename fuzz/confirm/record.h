// The record: the deterministic result of a run, and run.json, which holds everything that varies between runs.
#pragma once

#include <string>

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/confirm/plan.h"
#include "fuzz/text/json.h"

namespace axiscert {

inline constexpr const char* record_schema = "axiscert-record/3";

// record.json: contains no clock, host, thread count, target or compiler.
// Makes the witnesses' queries again and examines each by all oracles.
Json record_of(const Plan& plan, const CampaignResult& result, const Required& required);

// Counts of a tally as a family of the record has them, and those of its findings by kind: what levels read, and adds
// up over stretches. Without medians, places and addresses.
Json counts_json(const Kernel& kernel, const Tally& tally);
// The critical radius of all queries of a tally.
Json critical_radius_json(CriticalRadiusTally tally);
// A family's member "invariance".
Json invariance_of(const SeededSource& of, const Asymmetry& asymmetry);

// run.json: times, throughput, machine, target, compiler and library versions. `started` is ISO 8601, UTC.
Json run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
              const std::string& started, double seconds);

// An entry of the record's "kernels": what the kernel says of itself, without figures and families. `plugins`: files
// that were given by path, its own among them.
Json entry_json(const std::vector<FileInfo>& plugins, const Kernel& kernel, Precision precision);

// A query as in the query file: each group of the entry's columns as an array of hex strings, or as one string.
template <class Real>
void put_query(Json& into, const TestEntry& entry, const Numbers<Real>& numbers);
// The data that a kernel exposes: "verdict", and "comparisons" and "sides" if it exposes them.
Json exposures_json(const Kernel& kernel);
// The limits that a kernel declares; null if it has none, and null for each limit that it does not set.
Json limits_json(const Limits& limits);
// A JSON number; text if binary64 cannot represent it.
Json decimal_json(Decimal6 decimal);
// Flips in the form in which `check` and the witnesses list them.
Json flips_json(const TestDescription& test, const Judgement& judgement);

}  // namespace axiscert
