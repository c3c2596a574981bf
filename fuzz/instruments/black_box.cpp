#include "fuzz/instruments/black_box.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <deque>

#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"
#include "fuzz/instruments/for_each_judged.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {
namespace {

// Kernels whose answers to one query share its truth; a group is the work of one thread.
constexpr std::size_t group_size = 32;
// Each round asks eight times as many queries as the one before: nearly all mutants are refused in the first.
constexpr std::uint64_t round_growth = 8, rounds = 3;
// Wrong verdicts of a mutant whose depth is found, for each family and batch.
constexpr int depths_each = 4;

}  // namespace

Record record_of_kernels(const MutationPlan& plan, Precision precision, std::uint64_t trials,
                         std::vector<const Kernel*> kernels) {
  Plan campaign;
  campaign.questions.seed = plan.seed;
  campaign.answerers.kernels = std::move(kernels);
  for (const Family* family : plan.families) campaign.questions.sources.push_back(family_source(*family));
  campaign.questions.precisions = {precision};
  campaign.questions.trials = [trials](const Source&, Precision) { return trials; };
  campaign.running.target = std::string(scalar_target);
  CampaignResult result;
  result.cells = cells_of(campaign.questions, campaign.answerers.kernels.size());
  for (CellResult& cell : result.cells) {
    const Source& source = *campaign.questions.sources[cell.source];
    const std::uint64_t size = source.fixed_size(precision).value_or(trials);
    for (; cell.queries < size; ++cell.units_done) {
      const std::uint64_t queries = std::min(unit_size, size - cell.queries);
      const UnitResult done = run_unit(campaign, source, precision, cell.units_done, queries);
      for (std::size_t k = 0; k < cell.tallies.size(); ++k) cell.tallies[k].merge(done.tallies[k]);
      cell.queries += queries;
    }
  }
  return record_of(campaign, result, RunRequirements());
}

namespace {

std::optional<GateFailure> first_about(const std::vector<GateFailure>& failures, const std::string& kernel) {
  const auto found = std::find_if(failures.begin(), failures.end(),
                                  [&](const GateFailure& failure) { return failure.kernel == kernel; });
  return found == failures.end() ? std::nullopt : std::optional(*found);
}

// Whether x + E |x| and x - E |x| round to x for every x. The neighbours of x are at least 2^-24 |x| away in binary32,
// 2^-53 |x| in binary64, and E |x| is rounded once before it is added: half of half of that is lost for certain. Below
// the normal range E |x| is less than half of the least number.
bool is_lost(const mutants::Mutant& mutant, Precision precision) {
  using enum mutants::Quantity;
  if (!mutant.is_relative || !adds(mutant.value)) return false;
  if (mutant.quantity == side || mutant.quantity == verdict) return false;
  return mutant.magnitude <= (precision == Precision::binary32 ? 0x1p-26 : 0x1p-55);
}

using Survivals = std::vector<Survival>;  // by survivor

// Compares survivors with the kernel that they are made from on a batch of one family.
template <class Real>
void compare(const MutationPlan& plan, const std::vector<BlackBoxResult*>& survivors, JudgedBatch<Real>& batch,
             Survivals& found) {
  const Family& family = *plan.families[batch.source_index()];
  const auto bits_of = [&](const mutants::Mutant& mutant) {
    std::vector<ComparisonBits> bits(batch.size());
    mutants::mutant_bits(mutant, batch.queries().columns(), bits.data());
    return bits;
  };
  mutants::Mutant without_fault;
  without_fault.id = plan.base;
  std::vector<Verdict> base;
  for (const ComparisonBits bits : bits_of(without_fault)) base.push_back(verdict_of(family.predicate(), bits));
  std::uint64_t valid = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) valid += batch.oracles().is_valid(batch[i]);
  for (std::size_t m = 0; m < survivors.size(); ++m) {
    const std::vector<ComparisonBits> bits = bits_of(*survivors[m]->mutant);
    Survival& counts = found[m];
    counts.queries += batch.size();
    counts.valid += valid;
    int depths = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const Verdict verdict = verdict_of(family.predicate(), bits[i]);
      if (verdict == base[i]) continue;
      ++counts.other_verdicts;
      const Truth& truth = batch.truth(i);
      if (truth.verdict == Verdict::invalid || truth.verdict == verdict) continue;
      ++counts.wrong;
      if (family.exact_arithmetic) ++(truth.touching ? counts.touching_in_exact : counts.wrong_in_exact);
      if (truth.touching || depths++ >= depths_each) continue;
      const double deep = batch.oracles().depth(batch[i]).value_or(0);
      if (!counts.deepest || deep > counts.deepest->depth) counts.deepest = {&family, batch.position(i), deep};
    }
  }
}

class Judge {
 public:
  Judge(const MutationPlan& plan, const Gate& gate, const std::atomic<bool>& interrupted, const ShowProgress& report)
      : plan_(plan), gate_(gate), interrupted_(interrupted), report_(report) {
    for (const Precision precision : plan.precisions) {
      for (const mutants::Mutant* mutant : plan.mutants) {
        if (precision == Precision::binary64 || mutant->in_binary32)
          score_.mutants.push_back({mutant, precision, is_lost(*mutant, precision), {}, 0, {}});
      }
    }
  }

  BlackBoxScore run() && {
    std::uint64_t divisor = 1;
    for (std::uint64_t round = 1; round < rounds; ++round) divisor *= round_growth;
    for (; divisor != 0; divisor /= round_growth) {
      const std::uint64_t trials = plan_.trials / divisor;
      if (trials != 0 || divisor == 1) judge_all(trials);
    }
    if (plan_.controls) judge_controls();
    for (const Precision precision : plan_.precisions) {
      if (precision == Precision::binary32) explain<float>();
      else explain<double>();
    }
    score_.complete = !interrupted_;
    return std::move(score_);
  }

 private:
  // Those that no round has refused so far.
  void judge_all(std::uint64_t trials) {
    std::vector<std::vector<BlackBoxResult*>> groups;
    for (BlackBoxResult& result : score_.mutants) {
      if (result.refused) continue;
      const bool is_full =
          groups.empty() || groups.back().size() == group_size || groups.back().front()->precision != result.precision;
      if (is_full) groups.emplace_back();
      groups.back().push_back(&result);
    }
    ProgressCount progress(report_, groups.size(), "judged by verdicts alone");
    tbb::parallel_for(std::size_t{0}, groups.size(), [&](std::size_t g) {
      if (interrupted_) return;
      judge(groups[g], trials);
      progress.finish_unit(trials * plan_.families.size() * groups[g].size());
    });
  }

  void judge(const std::vector<BlackBoxResult*>& group, std::uint64_t trials) {
    std::deque<Kernel> boxes;
    std::vector<const Kernel*> kernels;
    for (const BlackBoxResult* result : group) {
      kernels.push_back(&boxes.emplace_back(mutants::black_box_of(*result->mutant)));
    }
    const auto failures = gate_(record_of_kernels(plan_, group.front()->precision, trials, std::move(kernels)));
    for (BlackBoxResult* result : group) {
      result->trials = trials;
      result->refused = first_about(failures, result->mutant->id);
    }
  }

  void judge_controls() {
    std::deque<Kernel> boxes;
    std::vector<const Kernel*> kernels;
    for (const std::string_view id : capabilities_of(*find_kernel(plan_.base).predicate).correct_forms) {
      Kernel& box = boxes.emplace_back(find_kernel(id));
      box.formulae.clear();
      box.exposes = Exposure::verdict;
      box.is_reference = false;
      kernels.push_back(&box);
    }
    ProgressCount progress(report_, plan_.precisions.size(), "kernels that are right");
    for (const Precision precision : plan_.precisions) {
      if (interrupted_) return;
      const auto failures = gate_(record_of_kernels(plan_, precision, plan_.trials, kernels));
      for (const Kernel& box : boxes) {
        if (box.has(precision)) score_.controls.push_back({box.id, precision, first_about(failures, box.id)});
      }
      progress.finish_unit(plan_.trials * plan_.families.size() * kernels.size());
    }
  }

  template <class Real>
  void explain() {
    std::vector<BlackBoxResult*> survivors;
    for (BlackBoxResult& result : score_.mutants) {
      if (result.precision == precision_of<Real> && !result.refused && !result.is_as_base) survivors.push_back(&result);
    }
    std::vector<SourcePtr> sources;
    for (const Family* family : plan_.families) sources.push_back(family_source(*family));
    JudgedPlan judged = judged_plan(std::move(sources), plan_.trials, plan_.seed, batch_size, plan_.threads);
    judged.order = BlockOrder::by_position;
    judged.interrupted = &interrupted_;
    const auto visit = [&](JudgedBatch<Real>& batch, Survivals& found) { compare(plan_, survivors, batch, found); };
    const Survivals found = for_each_judged<Real>(judged, Survivals(survivors.size()), report_, "survivors compared",
                                                  visit, axiscert::merge<Survivals>)
                                .counts;
    for (std::size_t m = 0; m < survivors.size(); ++m) survivors[m]->survival = found[m];
  }

  const MutationPlan& plan_;
  const Gate& gate_;
  const std::atomic<bool>& interrupted_;
  const ShowProgress& report_;
  BlackBoxScore score_;
};

}  // namespace

BlackBoxScore judge_black_boxes(const MutationPlan& plan, const Gate& gate, const std::atomic<bool>& interrupted,
                                const ShowProgress& report) {
  BlackBoxScore score;
  tbb::task_arena arena(plan.threads);
  arena.execute([&] { score = Judge(plan, gate, interrupted, report).run(); });
  return score;
}

}  // namespace axiscert
