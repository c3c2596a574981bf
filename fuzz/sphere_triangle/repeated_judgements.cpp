#include "fuzz/sphere_triangle/repeated_judgements.h"

namespace axiscert {

RepeatedJudgement* RepeatedJudgements::find(const JudgementPattern& pattern) {
  if (table_.empty()) table_.resize(size);
  std::uint64_t word = pattern.signs.strict;
  for (const ComparisonBits bits : {ComparisonBits{pattern.signs.ties}, pattern.range_free, pattern.reference})
    word = word << 16 | bits;
  // The golden ratio's multiples are spread evenly in the upper bits; what else a pattern has is nearly always the
  // same.
  const std::uint64_t first = (word * 0x9e3779b97f4a7c15u) >> 48;
  for (std::size_t i = 0; i < probes; ++i) {
    RepeatedJudgement& entry = table_[(first + i) % size];
    if (!entry.is_known || entry.pattern == pattern) return &entry;
  }
  return nullptr;
}

void RepeatedJudgements::add_to(Tally& tally) const {
  for (const RepeatedJudgement& of : table_) {
    if (of.repetitions == 0) continue;
    const Truth truth{of.truth, of.is_touching};
    count_numbers(tally, truth, of.pattern.signs.ties, of.answer, of.judgement, of.repetitions);
  }
}

}  // namespace axiscert
