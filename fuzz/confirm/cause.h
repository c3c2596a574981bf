// Why a kernel is wrong: the kernel is asked again, and its wrong verdicts are put beside what the exact answers say.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/source.h"
#include "fuzz/record/cause_record.h"
#include "fuzz/record/record.h"

namespace axiscert {

// A source of a run in one precision: its queries, and positions at which the run found wrong verdicts.
struct CauseSource {
  SeededSource asked;
  std::uint64_t queries;
  std::vector<std::uint64_t> wrong = {};
};

// Asks the kernel clear queries among up to 32,768 of these sources (8,192 of a predicate without filters), in their
// precision, and finds the traits of some 4,000. Where it is right on all of them and has no reference, those of
// sources with exact arithmetic follow, and then queries whose depth is above 64 u; touching ones never. Empty where it
// is right on these too, or the predicate has no traits. Depends on the kernel, the sources and the seed alone. Throws
// OracleDisagreement.
std::optional<CauseRecord> cause_of(const Kernel& kernel, std::span<const CauseSource> sources,
                                    const std::string& target);

// The cause of one kernel of a run, by its number in the plan, on the run's sources in one precision; empty where it
// has no wrong verdicts. A kernel that has a reference is asked only if more than rounding and the range make it wrong.
std::optional<CauseRecord> cause_in_run(const Plan& plan, const CampaignResult& result, std::size_t kernel,
                                        Precision precision);

// Those of all kernels of a record; none where the answers are replies, or the run was interrupted.
void put_causes(Record& record, const Plan& plan, const CampaignResult& result);

}  // namespace axiscert
