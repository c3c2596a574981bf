#include "fuzz/campaign/clear_look.h"

namespace axiscert {
namespace {

void count_answer(ClearTally& tally, std::uint64_t position, Verdict said, Verdict right) {
  ++tally.queries;
  if (said == right) return;
  switch (said) {
    case Verdict::separated:
      ++tally.false_separation;
      tally.first_missed.offer({true, position});
      break;
    case Verdict::contact:
      ++tally.false_contact;
      tally.first_phantom.offer({true, position});
      break;
    case Verdict::undecided:
      ++tally.undecided;
      break;
    default:
      ++tally.unanswered;
  }
}

}  // namespace

template <class Real>
void look_at_clear(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs) {
  std::vector<KernelRun<Real>*> looked_at;
  for (KernelRun<Real>& run : runs) {
    if (!has_reference(run.kernel())) looked_at.push_back(&run);
  }
  if (looked_at.empty()) return;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> numbers = batch.queries[i];
    const std::optional<Verdict> right = oracles.clear_verdict(numbers);
    if (!right) continue;
    for (KernelRun<Real>* run : looked_at) {
      const Kernel& kernel = run->kernel();
      if (is_promised(oracles, kernel.limits, kernel.motion, numbers))
        count_answer(*run->tally().verdict.clear, run->position(i), run->answer(i).verdict, *right);
    }
  }
}
template void look_at_clear(const Oracles&, const MadeBatch<float>&, KernelRuns<float>&);
template void look_at_clear(const Oracles&, const MadeBatch<double>&, KernelRuns<double>&);

}  // namespace axiscert
