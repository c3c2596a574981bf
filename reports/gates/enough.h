// Whether a level has looked at enough of each family to say "met" of a kernel, and what of a file it could not ask it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/record/record.h"
#include "reports/gates/level.h"
#include "reports/gates/requirement.h"

namespace axiscert {

// Why a kernel entry shows nothing, or not all that was asked for; empty where it does.
std::string gap_of(const Record& record, const Subject& subject, const AskedLevel& asked);

// How much of each family was looked at. Fills in what the outcome says of it; returns why that is too little, or is
// empty.
std::string weigh(const Subject& subject, const LevelFindings& found, double share, LevelOutcome& outcome);

// "; the fewest of a family, 64 independent queries of tangent, show with 95 % that fewer than 4.57 % are wrong";
// queries that share a triangle count once. Nothing of a level with a yardstick, which is met by as many wrong ones as
// another kernel has.
std::string fewest_text(const Subject& subject, const LevelFindings& found, const AskedLevel& asked);

// Queries of a file in a precision in which they were not asked.
struct UntakenLines {
  std::string family;
  Precision precision;
  std::uint64_t count, all;
  const char* why;

  // "6 of 7 queries of queries/bad.jsonl, which are of binary64: it does not exist in it".
  std::string text() const;
};
// A kernel does not exist in it.
std::vector<UntakenLines> lines_it_cannot_take(const Record& record, const std::string& id);
// --precision chose the other one.
std::vector<UntakenLines> lines_left_out(const Record& record);

}  // namespace axiscert
