#include "fuzz/campaign/stages/screen.h"

#include "fuzz/queries/capabilities.h"

namespace axiscert {
namespace {

// No filter: the oracles judge every answer.
template <class Real>
class NoScreen final : public Screen<Real> {
 public:
  explicit NoScreen(const ScreenedRuns<Real>& of) : of_(of) {}

  void decide(const MadeBatch<Real>& batch) override {
    queries_ = &batch.queries;
    of_.steps.queries[Step::exact] += batch.size();
  }
  AskedQuery& about(std::size_t i) override {
    asked_ = of_.oracles.about((*queries_)[i], of_.judging.exact_only ? Opinion::exact_only : Opinion::first);
    for (const KernelRun<Real>& run : of_.runs) asked_->expect(run.kernel());
    return *asked_;
  }
  void look_at_answer(std::size_t k, std::size_t i, const typename KernelRun<Real>::JudgedAnswer& found) override {
    KernelRun<Real>& run = of_.runs[k];
    if (!found.is_counted || !found.chain || !run.shows_sides() || !run.is_answered(i)) return;
    const ExactSides* sides = asked_->sides(run.kernel());
    if (sides == nullptr) return;
    count_errors(run.tally(), run.position(i), *run.kernel().predicate, *sides, run.reply().answers, i,
                 of_.judging.tolerances);
  }

 private:
  const ScreenedRuns<Real> of_;
  const QueryBatch<Real>* queries_ = nullptr;
  std::unique_ptr<AskedQuery> asked_;
};

}  // namespace

template <class Real>
std::unique_ptr<Screen<Real>> screen_of(const ScreenedRuns<Real>& of) {
  if (const Screens* screens = capabilities_of(*of.runs.front().kernel().predicate).screens) return screens->screen(of);
  return std::make_unique<NoScreen<Real>>(of);
}
template std::unique_ptr<Screen<float>> screen_of(const ScreenedRuns<float>&);
template std::unique_ptr<Screen<double>> screen_of(const ScreenedRuns<double>&);

}  // namespace axiscert
