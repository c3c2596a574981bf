// The worst query of a contender of the league: where it is, how wrong, and code to ask the engine by hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/league/league_data.h"
#include "reports/league/league_report.h"

namespace axiscert {

struct WorstQuery {
  const Kernel* kernel;
  const Source* source;
  Precision precision;
  std::uint64_t position;
  bool is_missed;  // its deepest missed contact; else, where it misses none, its deepest invented one
  double depth;    // a share of the scene, as everywhere

  std::string address(std::uint64_t seed) const;
};

// The worst of kernel `k` of the league in this precision; none where no verdict was wrong.
std::optional<WorstQuery> worst_of(const League& league, const CampaignResult& result, std::size_t k,
                                   Precision precision);

// "misses a contact 0.43 deep, where r is 0.98: 0.36 of the scene": the lengths in the query's own units, rounded.
std::string worst_sentence(const WorstQuery& worst, std::uint64_t seed);

// The query as a picture, the sentence, and the code with its numbers: that of a program's manifest, or the commands
// that make the query again and judge it. The code's numbers are decimals of which a double has every bit.
InstrumentScene worst_scene(const WorstQuery& worst, std::uint64_t seed);

// A row for each contender and precision, with a scene where a verdict was wrong; else it says among how many.
InstrumentTable worst_table(const League& league, const CampaignResult& result);
// One row's figures, its query and its code; none where no verdict was wrong.
std::optional<WorstData> worst_data(const League& league, const CampaignResult& result, std::size_t k,
                                    Precision precision);

}  // namespace axiscert
