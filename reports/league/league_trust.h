// "May I trust it?": what a contender of the league got wrong on each kind of input, in words and counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/family.h"
#include "reports/evidence/evidence.h"
#include "reports/league/league_report.h"

namespace axiscert {

// Number of queries within the kernel's limits on which it said contact or separated.
std::uint64_t decided(const Tally& tally);

// The answer to "may I trust it?", and the counts that it rests on.
struct Trust {
  // "yes", "rarely", "no", "too few" or "not looked at"
  std::string answer;
  std::string words;
  std::string text() const { return answer + ": " + words; }
};

// "yes: 0 of 4,096 wrong", "rarely: 3 of 4,096 missed", "no: 812 of 4,096 missed, 3 invented", "too few: 12 of 4,096
// decided", "not looked at: 0 of 4,096 decided"; then "; declines 120", "; calls 4 invalid", "; no answer to 14", "; 9
// outside its limits", where there are such. Less than one wrong in a thousand is rare. An answer `invalid`, none, or a
// decline that the kernel does not declare, is no trust, one being enough. Trust takes least_looked_at decided queries,
// and least_decided_share of the promised contacts and of the separations.
Trust trust_in(const Kernel& kernel, const Tally& tally);

// The groups of which a family was asked.
std::vector<TrustGroup> groups_asked(const std::vector<SourcePtr>& sources);
// All families of a group together; every family where there is none.
Tally tally_of_group(const League& league, const CampaignResult& result, std::size_t k, Precision precision,
                     std::optional<TrustGroup> group);

// A row for each contender that exists in the precision, a column for each kind of which a family was asked.
InstrumentTable trust_table(const League& league, const CampaignResult& result, Precision precision);

// "0.25"; "none of 4,096" where none was wrong; "not measured" where none was decided.
std::string depth_text(std::uint64_t wrong, std::uint64_t decided, double deepest);

}  // namespace axiscert
