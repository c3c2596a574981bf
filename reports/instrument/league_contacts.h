// What contenders of the league say beside their verdicts, in words: how far separations, normals and points are off,
// and the worst of each kind. The figures are those of a run's record.
#pragma once

#include "reports/instrument/league_report.h"

namespace axiscert {

// What a contender said on all families of a group together, without what it does not give; every family where there is
// no group.
ContactTally contacts_of_group(const League& league, const CampaignResult& result, std::size_t k, Precision precision,
                               std::optional<TrustGroup> group);

// Each of all families together, and of those of scenes, whose queries are in metres, alone. Where nothing of a kind
// was given: "not given". "off by up to 1.2 mm on scenes, 0.0003 of the scene; none beside 3": so many answers lack one
// beside other numbers.
std::string separation_words(const ContactTally& all, const ContactTally& scenes);
// "none"; "3 contacts with a separation above 0"
std::string contradiction_words(const ContactTally& all);
// "none of 4,096"; "12 of 4,096, leaving up to 2 of the depth"
std::string flip_words(const ContactTally& all);
// "tilted by up to 0.0123 degrees on scenes, 12.3 at most, length off by up to 1"
std::string normal_words(const ContactTally& all, const ContactTally& scenes);
std::string feature_words(const ContactTally& all);
// "off by up to 1e-07 of the scene on scenes, 0.5 at most"
std::string point_words(const ContactTally& all, const ContactTally& scenes);

// A row for each contender that exists in the precision.
InstrumentTable contacts_table(const League& league, const CampaignResult& result, Precision precision);
// The five worst of each kind among all contenders; `table` gets a row for each, with its query as a picture.
std::vector<WorstContactData> worst_contacts(const League& league, const CampaignResult& result,
                                             InstrumentTable& table);

InstrumentReport league_contacts_report(const League& league, const CampaignResult& result, const std::string& command);

}  // namespace axiscert
