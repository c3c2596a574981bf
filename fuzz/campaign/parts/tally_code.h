// Tallies as bytes (CBOR), for the journal and between ranks: equal tallies have equal bytes, in whatever order they
// were merged.
#pragma once

#include <string>
#include <string_view>

#include "fuzz/campaign/unit.h"

namespace axiscert {

// What a stretch cost: all of it in run.json, none of it in a record. It depends on the machine.
struct Costs {
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;
};

std::string encode(const Tally& tally);
std::string encode(const Costs& costs);
// Both throw Error where the bytes are none that encode() makes.
Tally decode_tally(std::string_view bytes);
Costs decode_costs(std::string_view bytes);

}  // namespace axiscert
