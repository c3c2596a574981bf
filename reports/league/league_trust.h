// "May I trust it?": what a contender of the league got wrong on each kind of input, in words and counts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/league/league_report.h"

namespace axiscert {

// A kind of input, and the families that make it.
struct TrustGroup {
  std::string_view name;
  std::vector<std::string_view> families;  // a name that ends with '*' stands for all that begin so

  bool has(std::string_view family) const;
};
const std::vector<TrustGroup>& trust_groups();
// Families of scenes as a game has them.
bool is_scene(std::string_view family);

// Number of queries that have a truth and to which the kernel gave an answer, which `undecided` and `invalid` are too.
std::uint64_t answered(const Tally& tally);

// "yes: 0 of 4,096 wrong", "rarely: 3 of 4,096 missed", "no: 812 of 4,096 missed, 3 invented", "nothing answered"; then
// "; declines 120", "; calls 4 invalid", "; no answer to 14", "; 9 outside its limits", where there are such. It counts
// of those on which the kernel said a verdict; less than one wrong in a thousand is rare.
std::string trust_words(const Tally& tally);

// A row for each contender that exists in the precision, a column for each kind of which a family was asked.
InstrumentTable trust_table(const League& league, const CampaignResult& result, Precision precision);

}  // namespace axiscert
