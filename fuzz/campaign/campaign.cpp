#include "fuzz/campaign/campaign.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <mutex>

#include "fuzz/fields/merge.h"

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

}  // namespace axiscert
