// Answers to clear queries: those that no right method of the precision gets wrong (exact/trait/clear.h).
#pragma once

#include <cstdint>
#include <string_view>

#include "fuzz/record/leaders.h"
#include "fuzz/fields/field.h"

namespace axiscert {

// Counts of a kernel without a reference: nothing else tells its faults of logic from its rounding.
struct ClearTally {
  std::uint64_t queries = 0, undecided = 0, unanswered = 0;
  std::uint64_t false_separation = 0, false_contact = 0;
  Leaders<bool> first_missed, first_phantom;  // by the position alone

  std::uint64_t wrong() const { return false_separation + false_contact; }
  std::uint64_t decided() const { return queries - undecided - unanswered; }
  bool operator==(const ClearTally& other) const {
    return queries == other.queries && undecided == other.undecided && unanswered == other.unanswered &&
           false_separation == other.false_separation && false_contact == other.false_contact;
  }

  static constexpr std::string_view about =
      "Answers to clear queries within the kernel's limits: no right method of the precision gets one wrong, since its "
      "margin is many times the bound of any rounding.";
  AXISCERT_FIELDS(ClearTally, AXISCERT_FIELD(queries, "Clear queries within the limits."),
                  AXISCERT_FIELD(undecided, "Those that the kernel declined."),
                  AXISCERT_FIELD(unanswered, "Those that it called invalid, or that got no answer."),
                  AXISCERT_FIELD(decided, "The rest."),
                  field(&Of::false_separation, figure_of("decided", "false_separation", "Missed contacts among them.")),
                  field(&Of::false_contact, figure_of("decided", "false_contact", "Phantom contacts among them.")),
                  journalled(&Of::first_missed), journalled(&Of::first_phantom))
};

}  // namespace axiscert
