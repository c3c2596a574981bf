// Tallies as bytes (CBOR), for the journal and between ranks: equal tallies have equal bytes, in whatever order they
// were merged.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/campaign/unit.h"

namespace axiscert {

// The cost of a stretch: all of it goes to run.json, none of it to a record. It depends on the machine.
struct Costs {
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;

  static constexpr auto fields(auto&& visit) {
    return visit(journalled(&Costs::core_seconds, by::added), journalled(&Costs::second_opinions),
                 journalled(&Costs::steps));
  }
};

std::string encode(const Tally& tally);
std::string encode(const Costs& costs);
// Both throw Error for bytes that encode() does not produce; a tally is of a predicate.
Tally decode_tally(std::string_view bytes, const Predicate& predicate);
Costs decode_costs(std::string_view bytes);

}  // namespace axiscert
