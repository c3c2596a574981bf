#include "proofs/certified/score.h"

#include "proofs/certified/equivalent.h"
#include "proofs/certified/step_queries.h"

namespace axiscert::proofs::certified {
namespace {

template <class Real>
StepScore score_in(const RecordedStep& step, std::size_t queries, std::uint64_t seed) {
  RecordedAnswers<Real> right(step);
  const QueryBatch<Real> batch = StepQueries<Real>(seed).of(right, queries);
  std::vector<StepAnswers> expected;
  for (std::size_t i = 0; i < batch.size(); ++i) expected.push_back(right(batch[i]));
  StepScore score{.step = step.name, .bits = step.bits};
  for (const Mutant& mutant : mutants_of(step)) {
    const RecordedStep planted = with(mutant, step);
    RecordedAnswers<Real> wrong(planted);
    bool is_seen = false;
    for (std::size_t i = 0; i < batch.size() && !is_seen; ++i) is_seen = wrong(batch[i]) != expected[i];
    const bool is_equivalent = reason_of_equivalence(step, mutant.name) != nullptr;
    ++score.mutants;
    if (is_equivalent) score.equivalent.push_back(mutant.name);
    else if (!is_seen) score.unseen.push_back(mutant.name);
    if (is_equivalent && is_seen)
      score.contradictions.push_back(mutant.name + ": is argued to be equivalent, and shown");
  }
  return score;
}

}  // namespace

StepScore score_of(const RecordedStep& step, std::size_t queries, std::uint64_t seed) {
  return step.bits == 32 ? score_in<float>(step, queries, seed) : score_in<double>(step, queries, seed);
}

}  // namespace axiscert::proofs::certified
