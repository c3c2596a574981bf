// The record: the deterministic result of a run, and run.json, which holds everything that varies between runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/record/plan_record.h"
#include "fuzz/record/record.h"
#include "fuzz/record/run_info.h"

namespace axiscert {
// The plan of a run as its record states it.

// The requirements of a run, as they were given: levels, and those of them that may be left unchecked.
struct RunRequirements {
  std::vector<std::string> levels = {}, allow_unchecked = {};
  std::string unit = {};  // of length, of the queries' numbers (fuzz/text/number_text.h); empty: it is not said
};

// Only the cells' units and queries of the result are used.
PlanRecord plan_record(const Plan& plan, const CampaignResult& result, const RunRequirements& required);
// The same of a plan that is done whole.
PlanRecord plan_record(const Plan& plan, const RunRequirements& required = {});

// Contains no clock, host, thread count, target or compiler.
// Makes the witnesses' queries again and examines each by all oracles.
Record record_of(const Plan& plan, const CampaignResult& result, const RunRequirements& required);

// Counts of a tally as a family of the record has them, and those of its findings by kind: what levels read, and adds
// up over stretches. Without medians, places and addresses.
Json counts_json(const Kernel& kernel, const Tally& tally);
std::map<ImageKind, ImageChangesRecord> invariance_of(const SeededSource& of, const Asymmetry& asymmetry);

// run.json: times, throughput, machine, target, compiler and library versions. `started` is ISO 8601, UTC.
RunInfo run_info(const Plan& plan, const CampaignResult& result, const std::string& target_asked,
                 const std::string& started, double seconds);

// What the kernel says of itself, without figures and families. `plugins`: files that were given by path, its own among
// them.
KernelRecord kernel_record(const std::vector<FileInfo>& plugins, const Kernel& kernel, Precision precision);
// The data that a kernel exposes: its verdict, its comparisons and their sides if it exposes them.
std::vector<Exposure> exposures_of(const Kernel& kernel);
// The limits that a kernel declares; empty if it has none, and empty for each limit that it does not set.
std::optional<LimitsRecord> limits_of(const Limits& limits);
// Its promises about motions.
PolicyRecord policy_of(const MotionPolicy& policy);
// The names of the measures that a kernel gives.
std::vector<Name> given_measures(const Kernel& kernel);

// The numbers of a query by the group of the entry's columns.
template <class Real>
NamedValues<GroupNumbers> groups_of_numbers(const PredicateEntry& entry, const Numbers<Real>& numbers);
// Flips in the form in which `check` and the witnesses list them.
std::vector<FlipRecord> flips_of(const Predicate& predicate, const Judgement& judgement);

// Findings, faults of somebody else's kernel other than wrong answers, as the record has them.

// Throws Error with the findings of loading it, if a kernel exists in no precision.
void require_loaded(const Kernel& kernel);
// Begins with a colon; empty where nothing was found.
std::string why_not_loaded(const Kernel& kernel);

// Appends the findings of loading the kernel, which belong to no precision, family or query.
void put_loading_findings(std::vector<FindingRecord>& findings, const Kernel& kernel);
// Appends the findings on one source, one entry a kind, with the first query that showed it.
void put_findings(std::vector<FindingRecord>& findings, const Kernel& kernel, const SeededSource& of,
                  const Tally& tally);

}  // namespace axiscert
