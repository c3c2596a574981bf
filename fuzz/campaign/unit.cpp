#include "fuzz/campaign/unit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fuzz/campaign/clear_look.h"
#include "fuzz/campaign/machine.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/stopwatch.h"

namespace axiscert {
template <class Real>
KernelRun<Real>::KernelRun(const Kernel& kernel, const std::string& target, const StoredReplies* replies,
                           const Source& source, const StandingLeaders& standing, Tally& tally)
    : kernel_(kernel),
      source_(source),
      replies_(replies),
      standing_(standing),
      tally_(tally),
      implementation_(kernel.on<Real>(target)),
      has_contacts_(says_contacts(kernel)) {}

template <class Real>
void KernelRun<Real>::ask_about(const MadeBatch<Real>& batch) {
  position_ = batch.position;
  if (replies_) return;
  ask(implementation_, batch.queries.columns(), reply_);
  for (const Finding& finding : reply_.watched.findings) {
    count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
  }
  tally_.asked_again += reply_.watched.asked_again;
}

template <class Real>
std::vector<double> KernelRun<Real>::measures(std::size_t i) const {
  return replies_ ? replies_->measures(source_, precision_of<Real>, position(i)) : reply_.measures(i);
}

template <class Real>
typename KernelRun<Real>::JudgedAnswer KernelRun<Real>::judge(std::size_t i, CloseLook<Real>& look) {
  const Answer said = answer(i);
  JudgedAnswer found{true, look.chain(kernel_)};
  found.judgement = axiscert::judge(*kernel_.predicate, look.truth(), found.chain, said, kernel_.touching);
  if (!look.is_promised_by(kernel_)) {
    count_outside(tally_, look.truth(), said, found.judgement, look.depth());
    found.is_counted = false;
    return found;
  }
  // Those of a kernel without limits are counted in bulk.
  if (kernel_.limits.any() && std::isfinite(look.depth().engine_threshold())) ++tally_.verdict.engine->queries;
  count(tally_, position(i), look.truth(), found.chain ? found.chain->ties : ComparisonBits{0}, said, found.judgement,
        look.depth(), standing_);
  return found;
}

template <class Real>
void KernelRun<Real>::finish() {
  if (!is_in_another_process() && !has_replies()) return;
  const VerdictTally& verdict = tally_.verdict;
  const OutsideTally& outside = *verdict.outside_limits;
  const std::uint64_t touching = tally_.truth.touching - outside.touching;
  const std::uint64_t apart = tally_.truth.separated - (outside.trials - outside.contact);
  const std::uint64_t overlapping = tally_.truth.contact - outside.contact - touching;
  // Any convention may be right where bodies touch.
  const WrongBothWays wrong{apart, std::min(verdict.false_contact, apart), overlapping,
                            std::min(verdict.false_separation, overlapping)};
  if (!wrong.are_exchanged()) return;
  FirstQuery first;
  for (const FirstQuery& of_link : verdict.first_by_link) first.merge(of_link);
  count_finding(tally_, FindingKind::exchanged, first.position.value_or(position_), wrong.text(kernel_));
}

template class KernelRun<float>;
template class KernelRun<double>;

namespace {

// No filter: the oracles judge every answer.
template <class Real>
class NoScreen final : public Screen<Real> {
 public:
  explicit NoScreen(const ScreenedRuns<Real>& of) : of_(of) {}

  void decide(const MadeBatch<Real>& batch) override {
    queries_ = &batch.queries;
    all_.resize(batch.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    of_.steps.queries[Step::exact] += batch.size();
  }
  const std::vector<std::size_t>& count_in_bulk() override { return all_; }
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
  std::vector<std::size_t> all_;  // of the batch
  std::unique_ptr<AskedQuery> asked_;
};

template <class Real>
std::unique_ptr<Screen<Real>> screen_of(const ScreenedRuns<Real>& of) {
  if (const Screens* screens = capabilities_of(*of.runs.front().kernel().predicate).screens) return screens->screen(of);
  return std::make_unique<NoScreen<Real>>(of);
}

// Judges what the screen leaves open by the oracles, which are asked once for all kernels; `with_contacts`: also what
// kernels say beside their verdicts.
template <class Real>
void judge(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs, Screen<Real>& screen,
           const std::vector<std::size_t>& open, bool with_contacts) {
  for (const std::size_t i : open) {
    std::optional<Numbers<Real>> numbers;
    std::optional<CloseLook<Real>> look;
    std::optional<ContactLook<Real>> contacts;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      if (screen.try_judge(k, i)) continue;
      if (!numbers) numbers = batch.queries[i];
      if (!look) look.emplace(oracles, *numbers, screen.about(i));
      const auto found = runs[k].judge(i, *look);
      screen.look_at_answer(k, i, found);
      if (!with_contacts || !runs[k].has_contacts() || !found.is_counted || !look->is_valid()) continue;
      if (!contacts) contacts.emplace(oracles, *numbers);
      runs[k].count_contact_of(i, *contacts, [&] { return look->truth(); });
    }
  }
}

// Where a screen judges verdicts without any oracle, what is said beside them, which takes a hundred times as long, is
// judged on so many of the first queries of a source.
constexpr std::uint64_t most_contacts = std::uint64_t{1} << 12;

// Judges that.
template <class Real>
void judge_contacts(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs) {
  if (std::none_of(runs.begin(), runs.end(), [](const auto& run) { return run.has_contacts(); })) return;
  for (std::size_t i = 0; i < batch.size() && batch.position + i < most_contacts; ++i) {
    const Numbers<Real> numbers = batch.queries[i];
    if (!oracles.is_valid(numbers)) continue;
    ContactLook<Real> contacts(oracles, numbers);
    for (KernelRun<Real>& run : runs) {
      if (!run.has_contacts() || !is_promised(oracles, run.kernel().limits, run.kernel().motion, numbers)) continue;
      run.count_contact_of(i, contacts, [&] { return oracles.truth(numbers); });
    }
  }
}

// One unit in one precision, batch by batch: made, asked of every kernel, decided, judged.
template <class Real>
void run(const Plan& plan, const Source& source, std::uint64_t first, std::uint64_t size,
         const std::vector<StandingLeaders>& standing, const BatchDone& asked, UnitResult& out) {
  const StandingLeaders nothing = standing_of(empty_tally(source.predicate()));
  KernelRuns<Real> runs;
  for (std::size_t k = 0; k < plan.answerers.kernels.size(); ++k) {
    const Kernel& kernel = *plan.answerers.kernels[k];
    if (!kernel.has(precision_of<Real>) || kernel.entry != source.entry()) continue;
    runs.emplace_back(kernel, plan.running.target, plan.answerers.replies.get(), source,
                      standing.empty() ? nothing : standing[k], out.tallies[k]);
  }
  if (runs.empty()) return;
  const bool any_process = std::any_of(runs.begin(), runs.end(), [](auto& run) { return run.is_in_another_process(); });
  const std::size_t most = any_process ? batch_size_for_processes : batch_size;
  const Oracles& oracles = oracles_of(source.predicate(), source.entry());
  StepCounts& steps = out.steps;
  const auto screen =
      screen_of<Real>({plan.judging, plan.running.target, oracles, runs, first, steps, out.second_opinions});
  const bool is_screened = capabilities_of(source.predicate()).screens != nullptr;
  QueryBatch<Real> queries(most, source.columns().size());
  for (std::uint64_t done = 0; done < size; done += queries.size()) {
    Stopwatch watch;
    source.fill(plan.questions.seed, first + done, static_cast<std::size_t>(std::min<std::uint64_t>(most, size - done)),
                queries);
    const MadeBatch<Real> made{queries, first + done};
    steps.generation += watch.lap();
    for (KernelRun<Real>& run : runs) run.ask_about(made);
    steps.kernels += watch.lap();
    screen->decide(made);
    watch.lap();  // the filters keep their own time
    const std::vector<std::size_t>& open = screen->count_in_bulk();
    steps.judging += watch.lap();
    screen->look_at_errors();
    steps.errors += watch.lap();
    look_at_clear(oracles, made, runs);
    judge(oracles, made, runs, *screen, open, !is_screened);
    if (is_screened) judge_contacts(oracles, made, runs);
    screen->sample();
    steps.judging += watch.lap();
    if (asked) asked(queries.size());
  }
  screen->finish();
  for (KernelRun<Real>& run : runs) run.finish();
}

}  // namespace

UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<StandingLeaders>& standing, const BatchDone& asked) {
  UnitResult result{std::vector<Tally>(plan.answerers.kernels.size(), empty_tally(source.predicate())), 0, 0, {}};
  const double start = thread_seconds();
  const std::uint64_t first = number * unit_size;
  if (precision == Precision::binary32) run<float>(plan, source, first, size, standing, asked, result);
  else run<double>(plan, source, first, size, standing, asked, result);
  result.core_seconds = thread_seconds() - start;
  return result;
}

}  // namespace axiscert
