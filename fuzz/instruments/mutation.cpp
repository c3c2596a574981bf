#include "fuzz/instruments/mutation.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <sstream>

#include "exact/judge/examine.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// A batch of one family, and the truth known about it, which is found when it is first needed: few queries need it.
template <class Real>
struct FamilyBatch {
  const Family* family;
  const Oracles* oracles = &oracles_of(family->predicate(), family->entry);
  QueryBatch<Real> batch{batch_size, family->column_count()};
  std::vector<ComparisonBits> base;
  std::vector<Verdict> base_verdicts;
  // For each query: -1, 0, 1 where the two overlap, touch or are apart, or one of these. Threads that ask at the same
  // time find the same.
  static constexpr signed char unknown = 2, invalid = 3;
  std::vector<std::atomic<signed char>> order = std::vector<std::atomic<signed char>>(batch_size);
  bool has_valid = false;  // of all batches so far

  explicit FamilyBatch(const Family* of) : family(of) {}
  const Predicate& predicate() const { return family->predicate(); }

  // Makes `size` queries of the family from position `first` on, and the answers of the kernel without a fault.
  void prepare(const mutants::Mutant& without_fault, std::uint64_t seed, std::uint64_t first, std::size_t size) {
    batch.resize(size);
    family->fill(seed, first, batch.mutable_columns());
    base.resize(size);
    mutants::mutant_bits(without_fault, batch.columns(), base.data());
    base_verdicts.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      base_verdicts[i] = verdict_of(predicate(), base[i]);
      order[i].store(unknown, std::memory_order_relaxed);
      has_valid = has_valid || oracles->is_valid(batch[i]);
    }
  }

  bool shows_formulae() const { return axiscert::shows_formulae(family->name, family->exact_arithmetic); }

  signed char order_of(std::size_t i) {
    signed char known = order[i].load(std::memory_order_relaxed);
    if (known != unknown) return known;
    const Truth truth = oracles->truth(batch[i]);
    known = truth.verdict == Verdict::invalid     ? invalid
            : truth.touching                      ? 0
            : truth.verdict == Verdict::separated ? 1
                                                  : -1;
    order[i].store(known, std::memory_order_relaxed);
    return known;
  }
  // Whether that verdict is wrong, touching being contact.
  bool is_wrong(std::size_t i, Verdict verdict) {
    const signed char known = order_of(i);
    return known != invalid && (known > 0) != (verdict == Verdict::separated);
  }
};

template <class Real>
class MutationRun {
 public:
  MutationRun(const MutationPlan& plan, std::vector<MutantResult*> results)
      : plan_(plan), results_(std::move(results)) {
    base_.id = plan.base;
    for (const Family* family : plan.families) {
      asked_.emplace_back(family);
      exact_families_ += asked_.back().shows_formulae();
    }
  }

  // Asks every mutant that is not done the queries of each family from `first` on.
  std::uint64_t run_batch(std::uint64_t first) {
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(batch_size, plan_.trials - first));
    first_ = first;
    tbb::parallel_for(std::size_t{0}, asked_.size(),
                      [&](std::size_t f) { asked_[f].prepare(base_, plan_.seed, first, size); });
    tbb::parallel_for(std::size_t{0}, results_.size(), [&](std::size_t m) { ask(*results_[m]); });
    return size * asked_.size();
  }

  bool has_valid() const {
    return std::ranges::any_of(asked_, [](const FamilyBatch<Real>& asked) { return asked.has_valid; });
  }

 private:
  void ask(MutantResult& result) {
    std::array<ComparisonBits, batch_size> bits;
    std::uint64_t before = first_ * asked_.size(), before_exact = first_ * exact_families_;
    for (FamilyBatch<Real>& asked : asked_) {
      const bool is_exact = asked.shows_formulae();
      if (!result.by_bits || (is_exact && !result.by_formulae)) {
        mutants::mutant_bits(*result.mutant, asked.batch.columns(), bits.data());
        for (std::size_t i = 0; i < asked.batch.size(); ++i) {
          if (bits[i] == asked.base[i]) continue;
          result.same_bits = false;
          look(result, asked, i, bits[i], before + i + 1, before_exact + i + 1);
        }
      }
      before += asked.batch.size();
      if (is_exact) before_exact += asked.batch.size();
    }
  }

  void look(MutantResult& result, FamilyBatch<Real>& asked, std::size_t i, ComparisonBits bits, std::uint64_t queries,
            std::uint64_t exact_queries) {
    const Verdict verdict = verdict_of(asked.predicate(), bits);
    if (verdict == asked.base_verdicts[i]) return;
    if (!asked.is_wrong(i, verdict)) return;
    const bool in_exact_arithmetic = asked.shows_formulae() && asked.order_of(i) != 0;
    if (result.by_bits && (result.by_formulae || !in_exact_arithmetic)) return;
    const Catch found = confirmed(*result.mutant, asked, i, {verdict, bits}, in_exact_arithmetic);
    if (!result.by_bits) {
      result.by_bits = found;
      result.by_bits->queries = queries;
    }
    if (in_exact_arithmetic && !result.by_formulae) {
      result.by_formulae = found;
      result.by_formulae->queries = exact_queries;
    }
  }

  Catch confirmed(const mutants::Mutant& mutant, const FamilyBatch<Real>& asked, std::size_t i, const Answer& answer,
                  bool in_exact_arithmetic) const {
    const Numbers<Real> q = asked.batch[i];
    Kernel kernel = mutants::kernel_of(mutant);
    const Examination found = examine(q, kernel, answer);
    const auto require = [&](const Examination& examined, Link link) {
      if (examined.judgement.verdict_flip && examined.judgement.verdict_links.contains(link)) return;
      throw HarnessFault(fmt::format("{} is wrong on {} at {}, but the judge does not attribute that to {}", mutant.id,
                                     asked.family->name, first_ + i, link_names[link]));
    };
    require(found, Link::implementation);
    if (in_exact_arithmetic) {
      kernel.is_reference = false;
      require(examine(q, kernel, answer), Link::unattributed);
    }
    return {asked.family, first_ + i, 0, *found.judgement.verdict_flip, *found.depth};
  }

  const MutationPlan& plan_;
  std::vector<MutantResult*> results_;
  mutants::Mutant base_;  // the base without a fault
  std::deque<FamilyBatch<Real>> asked_;
  std::uint64_t first_ = 0, exact_families_ = 0;
};

}  // namespace

MutationResult run_mutation(const MutationPlan& plan, const std::atomic<bool>& interrupted,
                            const ShowProgress& report) {
  MutationResult result;
  for (const Precision precision : plan.precisions) {
    for (const mutants::Mutant* mutant : plan.mutants) {
      if (precision == Precision::binary64 || mutant->in_binary32)
        result.mutants.push_back({mutant, precision, {}, {}});
    }
  }
  const std::uint64_t batches = (plan.trials + batch_size - 1) / batch_size;
  ProgressCount progress(report, batches * plan.precisions.size(), "mutants");
  const auto run = [&]<class Real>(Real) {
    std::vector<MutantResult*> of_precision;
    for (MutantResult& r : result.mutants) {
      if (r.precision == precision_of<Real>) of_precision.push_back(&r);
    }
    MutationRun<Real> mutation(plan, std::move(of_precision));
    for (std::uint64_t first = 0; first < plan.trials; first += batch_size) {
      if (interrupted) {
        result.complete = false;
        return;
      }
      progress.finish_unit(mutation.run_batch(first));
      if (mutation.has_valid()) result.judged.insert(precision_of<Real>);
    }
  };
  tbb::task_arena arena(plan.threads);
  arena.execute([&] {
    for (const Precision precision : plan.precisions) {
      if (precision == Precision::binary32) run(float{});
      else run(double{});
    }
  });
  return result;
}

// Correct kernels in other forms, which a harness that detects mutants must not flag.

namespace {

// In addition to the correct forms each arithmetic under the base.
std::vector<Kernel> kernels_of(const std::string& base) {
  std::vector<Kernel> kernels;
  for (const std::string_view id : capabilities_of(*find_kernel(base).predicate).correct_forms)
    kernels.push_back(find_kernel(id));
  for (const ArithmeticInfo& arithmetic : arithmetics()) {
    if (arithmetic.arithmetic != Arithmetic::plain) kernels.push_back(find_kernel(base + "+" + arithmetic.name));
  }
  return kernels;
}

// The same answers from a kernel that claims the formulae, but neither their order nor their rounding.
Kernel claiming_formulae_alone(Kernel kernel) {
  kernel.is_reference = false;
  kernel.arithmetic = Arithmetic::plain;
  kernel.exposes = std::min(kernel.exposes, Exposure::comparisons);
  return kernel;
}

std::uint64_t flagged(const VerdictTally& verdict, bool claims_bits, bool shows_formulae) {
  const auto wrong = [&](Link link) { return verdict.links[link]; };
  if (claims_bits) return wrong(Link::specification) + wrong(Link::implementation);
  if (!shows_formulae) return wrong(Link::specification);
  return wrong(Link::specification) + wrong(Link::unattributed) - verdict.touching_links[Link::unattributed];
}

}  // namespace

std::vector<Control> run_controls(const MutationPlan& plan, std::uint64_t trials, const std::atomic<bool>& interrupted,
                                  const ShowProgress& report) {
  std::vector<Kernel> kernels = kernels_of(plan.base);
  const std::size_t by_bits = kernels.size();
  for (std::size_t k = 0; k < by_bits; ++k) {
    // A method has no comparisons to claim; its scalar form is itself the reference.
    if (has_comparisons(kernels[k])) kernels.push_back(claiming_formulae_alone(kernels[k]));
  }
  Plan campaign;
  campaign.questions.seed = plan.seed;
  for (const Kernel& kernel : kernels) campaign.answerers.kernels.push_back(&kernel);
  for (const Family* family : plan.families) campaign.questions.sources.push_back(family_source(*family));
  campaign.questions.precisions = plan.precisions;
  campaign.questions.trials = [trials](const Source&, Precision) { return trials; };
  campaign.running.target = std::string(scalar_target);
  campaign.running.threads = plan.threads;
  const CampaignResult result = run_campaign(campaign, interrupted, report);
  std::vector<Control> controls;
  for (const Precision precision : plan.precisions) {
    for (std::size_t k = 0; k < kernels.size(); ++k) {
      if (!kernels[k].has(precision)) continue;
      Control& control = controls.emplace_back(Control{kernels[k].id, k < by_bits, precision});
      for (const CellResult& cell : result.cells) {
        if (cell.precision != precision) continue;
        const Tally& tally = cell.tallies[k];
        control.queries += tally.trials - tally.truth.invalid;
        const Source& source = *campaign.questions.sources[cell.source];
        control.flagged +=
            flagged(tally.verdict, control.claims_bits, shows_formulae(source.name(), source.exact_arithmetic()));
      }
    }
  }
  return controls;
}

Equivalents parse_equivalent_mutants(const std::string& text, const std::string& file) {
  Equivalents all;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    const auto fault = [&](const std::string& what) {
      return Error(fmt::format("{}:{}: {}; a line is NAME: REASON, as in 'nonstrict~sign:3: squared at once'", file,
                               number, what));
    };
    // A name contains a colon, but no colon followed by a space.
    const std::size_t end = line.find(": ");
    if (end == line.npos || end + 2 == line.size()) throw fault("no reason");
    const std::string name = line.substr(0, end);
    try {
      mutants::find_mutant(name);
    } catch (const Error& unknown) {
      throw fault(unknown.what());
    }
    if (!all.emplace(name, line.substr(end + 2)).second) throw fault(fmt::format("'{}' appears twice", name));
  }
  return all;
}

}  // namespace axiscert
