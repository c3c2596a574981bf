#include "fuzz/campaign/campaign.h"

#include <algorithm>

#include "fuzz/campaign/clear_look.h"
#include "fuzz/campaign/stages.h"
#include "fuzz/campaign/machine.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/stopwatch.h"

namespace axiscert {
namespace {

// Judges what the screen leaves open by the oracles, which are asked once for all kernels; `with_contacts`: also what
// kernels say beside their verdicts.
template <class Real>
void judge(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs, Screen<Real>& screen,
           bool with_contacts) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!screen.is_open(i)) continue;
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
    screen->look_at_errors();
    steps.errors += watch.lap();
    screen->count_in_bulk();
    look_at_clear(oracles, made, runs);
    judge(oracles, made, runs, *screen, !is_screened);
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
