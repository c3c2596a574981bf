#include "fuzz/campaign/campaign.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <numeric>

#include "fuzz/campaign/machine.h"
#include "fuzz/campaign/unit.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/merge.h"
#include "kernel/base/stopwatch.h"

namespace axiscert {
namespace {

struct Unit {
  std::size_t cell;
  std::uint64_t number, size;
};

// Hands out the units of a plan in a fixed order: one of each cell in turn, so that a run that is stopped has spent
// its time evenly. Under a time limit the units of a family never end.
class UnitQueue {
 public:
  UnitQueue(const Questions& questions, const std::vector<CellResult>& cells) : timed_(questions.seconds.has_value()) {
    for (const CellResult& cell : cells) {
      const Source& source = *questions.sources[cell.source];
      const auto fixed = questions.fixed_size(source, cell.precision);
      left_.push_back(fixed ? *fixed : timed_ ? UINT64_MAX : questions.trials(source, cell.precision));
      if (left_.back() != UINT64_MAX) total_ += (left_.back() + unit_size - 1) / unit_size;
    }
    next_number_.resize(cells.size());
  }
  std::uint64_t total() const { return timed_ ? 0 : total_; }

  std::optional<Unit> next() {
    for (std::size_t tried = 0; tried < left_.size(); ++tried) {
      const std::size_t cell = turn_++ % left_.size();
      if (left_[cell] == 0) continue;
      const std::uint64_t size = std::min(left_[cell], unit_size);
      if (left_[cell] != UINT64_MAX) left_[cell] -= size;
      return Unit{cell, next_number_[cell]++, size};
    }
    return std::nullopt;
  }

 private:
  bool timed_;
  std::uint64_t total_ = 0;
  std::size_t turn_ = 0;
  std::vector<std::uint64_t> left_, next_number_;
};

}  // namespace

void StepCounts::merge(const StepCounts& other) { merge_fields(*this, other); }

std::vector<CellResult> cells_of(const Questions& questions, std::size_t kernels) {
  std::vector<CellResult> cells;
  for (const Precision precision : {Precision::binary64, Precision::binary32}) {
    if (std::ranges::find(questions.precisions, precision) == questions.precisions.end()) continue;
    for (std::size_t s = 0; s < questions.sources.size(); ++s) {
      cells.push_back({s, precision, 0, 0, 0, std::vector<Tally>(kernels, empty_tally(questions.predicate())), {}});
    }
  }
  return cells;
}

std::set<std::string> targets_of(const std::vector<const Kernel*>& kernels, const std::string& target) {
  std::set<std::string> targets = {std::string(scalar_target), target};
  for (const Kernel* kernel : kernels) {
    if (!kernel->call.target.empty()) targets.insert(kernel->call.target);
  }
  return targets;
}

CampaignResult run_campaign(const Plan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report) {
  const Questions& questions = plan.questions;
  const std::vector<const Kernel*>& kernels = plan.answerers.kernels;
  const int threads = plan.running.threads;
  CampaignResult result;
  result.cells = cells_of(questions, kernels.size());
  UnitQueue queue(questions, result.cells);
  std::mutex mutex;
  std::atomic<bool> failed = false;
  ProgressCount progress(report, queue.total());
  const BatchDone asked = [&](std::uint64_t queries) { progress.add_queries(queries); };
  const auto start = std::chrono::steady_clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };

  // A unit, and what other units of its cell have found so far.
  const auto claim = [&](std::vector<StandingLeaders>& standing) -> std::optional<Unit> {
    const std::lock_guard lock(mutex);
    if (failed) return std::nullopt;
    if (interrupted) {
      result.complete = false;
      return std::nullopt;
    }
    if (questions.seconds && elapsed() >= *questions.seconds) return std::nullopt;
    const std::optional<Unit> unit = queue.next();
    standing.clear();
    if (unit) {
      for (const Tally& tally : result.cells[unit->cell].tallies) standing.push_back(standing_of(tally));
    }
    return unit;
  };
  const auto work = [&](int) {
    std::vector<StandingLeaders> standing;
    while (const auto unit = claim(standing)) {
      const CellResult& cell = result.cells[unit->cell];
      UnitResult done;
      try {
        done =
            run_unit(plan, *questions.sources[cell.source], cell.precision, unit->number, unit->size, standing, asked);
      } catch (...) {
        failed = true;
        throw;
      }
      const std::lock_guard lock(mutex);
      CellResult& into = result.cells[unit->cell];
      for (std::size_t k = 0; k < kernels.size(); ++k) into.tallies[k].merge(done.tallies[k]);
      into.steps.merge(done.steps);
      into.core_seconds += done.core_seconds;
      ++into.units_done;
      into.queries += unit->size;
      result.second_opinions += done.second_opinions;
      progress.finish_unit();
    }
  };
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  arena.execute([&] { tbb::parallel_for(0, threads, work, tbb::simple_partitioner()); });
  return result;
}

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
// judged on so many of the first queries of a source, and on all of a file.
constexpr std::uint64_t most_contacts = std::uint64_t{1} << 12;

// Judges that.
template <class Real>
void judge_contacts(const Oracles& oracles, const Source& source, const MadeBatch<Real>& batch,
                    KernelRuns<Real>& runs) {
  const std::uint64_t most = source.fixed_size(precision_of<Real>).value_or(most_contacts);
  if (std::none_of(runs.begin(), runs.end(), [](const auto& run) { return run.has_contacts(); })) return;
  for (std::size_t i = 0; i < batch.size() && batch.position + i < most; ++i) {
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
    if (is_screened) judge_contacts(oracles, source, made, runs);
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
