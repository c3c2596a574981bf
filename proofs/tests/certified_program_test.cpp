// The steps of the certified predicate are the recorded programs: on each instruction set, each step by itself answers
// as its recording does, evaluated operation by operation, also on queries an ulp to both sides of a change of an
// answer. And these queries show faults: constants halved and doubled, operands exchanged, conditions dropped; each
// changes the recording, shown or not.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "proofs/certified/mutants.h"
#include "proofs/certified/step_queries.h"
#include "proofs/emit.h"
#include "proofs/tests/certified_steps.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::proofs {
namespace {

using certified::RecordedAnswers, certified::RecordedStep;

constexpr std::uint64_t steps_seed = 20261124;

const std::vector<RecordedStep>& all_steps() {
  static const std::vector<RecordedStep> steps = certified::recorded_steps();
  return steps;
}
// The steps in this format, as an instruction set with or without fused multiply-add computes them.
template <class Real>
std::vector<const RecordedStep*> steps_in(bool fused) {
  std::vector<const RecordedStep*> found;
  for (const RecordedStep& step : all_steps()) {
    const bool is_fused = step.fused || (fused && step.name.starts_with("conservative"));  // which is never fused
    if (step.bits == 8 * sizeof(Real) && is_fused == fused) found.push_back(&step);
  }
  return found;
}

// A step that has decided every lane of a vector leaves out what else is known of them.
bool is_same(const RecordedStep& step, const StepAnswers& found, const StepAnswers& expected) {
  if (found.bits != expected.bits) return false;
  if (step.name == "coarse") return found.known == expected.known;
  if (step.name != "fine") return true;
  const bool closed = (expected.bits & 0b001100) != 0, open = (expected.bits & 0b110000) != 0;
  return (closed || found.known == expected.known) && (open || found.known_open == expected.known_open);
}

template <class Real>
class CertifiedSteps : public testing::Test {};
using StepReals = testing::Types<float, double>;
TYPED_TEST_SUITE(CertifiedSteps, StepReals);

TYPED_TEST(CertifiedSteps, AnswerAsTheyAreRecorded) {
  SCOPED_TRACE(testing::Message() << "seed " << steps_seed);
  std::map<const RecordedStep*, QueryBatch<TypeParam>> batches;
  for_each_simd_target([&](const std::string& target) {
    const StepForms forms = chosen_step_forms();
    for (const RecordedStep* step : steps_in<TypeParam>(forms.fused)) {
      if (step->name == "pair" && sizeof(TypeParam) == 8 && forms.lanes < 4) continue;
      RecordedAnswers<TypeParam> recorded(*step);
      if (!batches.contains(step)) {  // a number of queries that is not a multiple of any vector length
        batches.emplace(step, certified::StepQueries<TypeParam>(steps_seed).of(recorded, 1'203));
      }
      const QueryBatch<TypeParam>& batch = batches.at(step);
      std::array<const TypeParam*, coordinate_count> columns;
      std::copy_n(batch.columns().column.begin(), coordinate_count, columns.begin());
      std::vector<StepAnswers> found(batch.size());
      if constexpr (sizeof(TypeParam) == 4) forms.step32(step->name, columns.data(), batch.size(), found.data());
      else forms.step64(step->name, columns.data(), batch.size(), found.data());
      std::map<std::uint64_t, int> seen;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        const Query<TypeParam> query = batch[i];
        const StepAnswers expected = recorded(query);
        ++seen[expected.bits];
        // The lesser of a number and a NaN is the one that x86 takes in the recording, and emulated vectors may take
        // the other. A query with a NaN has no verdict.
        if (target == "EMU128" && !is_valid(query)) continue;
        ASSERT_TRUE(is_same(*step, found[i], expected))
            << step->name << " on " << target << ", query " << i << ": " << found[i].bits << " and not "
            << expected.bits << "; known " << found[i].known << " and not " << expected.known;
      }
      EXPECT_GE(seen.size(), 3u) << step->name << ": an answer never comes";
    }
  });
}

TYPED_TEST(CertifiedSteps, WouldShowAFault) {
  SCOPED_TRACE(testing::Message() << "seed " << steps_seed);
  for (const RecordedStep* step : steps_in<TypeParam>(false)) {
    if (step->name != "coarse" && step->name != "pair") continue;
    const certified::StepScore score = certified::score_of(*step, 12'000, steps_seed);
    EXPECT_GT(score.mutants, 40u);
    EXPECT_TRUE(score.unseen.empty()) << step->name << ": " << testing::PrintToString(score.unseen);
    EXPECT_TRUE(score.contradictions.empty()) << step->name << ": " << testing::PrintToString(score.contradictions);
  }
}

// The recording that the test proofs.Current compares shows every fault, in any step.
TEST(CertifiedFaults, ChangeTheRecording) {
  std::size_t faults = 0;
  std::set<const certified::Equivalent*> argued;
  for (const RecordedStep& step : all_steps()) {
    const std::string recorded = text_of(step);
    for (const certified::Mutant& mutant : certified::mutants_of(step)) {
      ++faults;
      if (text_of(certified::with(mutant, step)) == recorded) ADD_FAILURE() << step.name << ": " << mutant.name;
      if (!step.fused) argued.insert(certified::reason_of_equivalence(step, mutant.name));
    }
  }
  EXPECT_GT(faults, 4'000u);
  // Their names have the numbers of values in the recording that is committed, which is g++'s: clang evaluates operands
  // in another order.
#ifndef __clang__
  for (const certified::Equivalent& equivalent : certified::equivalent_faults()) {
    EXPECT_TRUE(argued.contains(&equivalent)) << equivalent.step << " has no fault '" << equivalent.fault << "'";
  }
#endif
}

}  // namespace
}  // namespace axiscert::proofs
