// Judgements that repeat. Where queries leave the range nearly all have flips, but all that judging looks at is a few
// words of bits, and a family has few different ones: each is judged once, and then counted.
#pragma once

#include "exact/sphere_triangle/filters/signs.h"
#include "fuzz/campaign/counts/tally.h"

namespace axiscert {

// All that the judgement of a query depends on, for one kernel whose answer has the bits of its reference or none: so
// queries with one pattern have one judgement.
struct JudgementPattern {
  Signs signs;
  ComparisonBits range_free, reference;
  Verdict answered;
  bool has_bits, radius_is_zero;
  bool operator==(const JudgementPattern&) const = default;
};

// A judgement, and how many queries had it after the first. Only the first is a witness: the later ones have the same
// flips at later positions.
struct RepeatedJudgement {
  JudgementPattern pattern{};
  Verdict truth{};
  bool is_touching = false;
  Answer answer{};
  Judgement judgement{};
  bool is_known = false;
  std::uint64_t repetitions = 0;

  std::optional<Flip> verdict_flip() const {
    if (!judgement.verdict_flip) return std::nullopt;
    return Flip{Level::verdict, 0, *judgement.verdict_flip, true, judgement.verdict_links};
  }
};

// A table of a fixed size: a pattern that finds no place is judged each time.
class RepeatedJudgements {
 public:
  // The entry of the pattern, or a free one for it; null where there is neither.
  RepeatedJudgement* find(const JudgementPattern& pattern);
  void add_to(Tally& tally) const;

 private:
  static constexpr std::size_t size = 2048, probes = 4;
  std::vector<RepeatedJudgement> table_;  // empty until first asked
};

}  // namespace axiscert
