#include "fuzz/sphere_triangle/formulae/condition.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#include "exact/sphere_triangle/unbounded.h"
#include "exact/sphere_triangle/measures/condition_number.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/text/merge.h"
#include "fuzz/sphere_triangle/formulae/valid_queries.h"
#include "fuzz/instruments/for_each_judged.h"

namespace axiscert {
namespace {

using ByComparison = std::array<std::uint64_t, comparison_count>;

// Comparisons of one kernel's answer to one query that are to be evaluated.
struct Request {
  std::uint64_t position;
  ComparisonBits flips, others;
};

struct KernelFindings {
  ByComparison flips{};
  std::vector<Request> requests;  // by position
  std::uint64_t false_separation = 0, false_contact = 0;
  std::vector<WrongVerdict> wrong;
};

struct Findings {
  std::size_t source;
  std::uint64_t valid = 0, invalid = 0;
  std::vector<KernelFindings> kernels;
};

// Removes from `flips` those whose count has reached the limit, and counts the rest.
ComparisonBits within_limit(ComparisonBits flips, std::uint64_t limit, ByComparison& taken) {
  for (std::size_t i = 0; i < comparison_count; ++i) {
    if (!has_bit(flips, i)) continue;
    if (taken[i] >= limit) flips &= ~one_bit<ComparisonBits>(i);
    else ++taken[i];
  }
  return flips;
}

ComparisonBits exact_bits(const ExactSides& sides, const Kernel& kernel) {
  return sides.holding(nonstrict_comparisons(kernel.strictness));
}

// Every flip and every wrong verdict among the queries of a block.
template <class Real>
Findings search_block(const ConditionPlan& plan, JudgedBatch<Real>& batch) {
  Findings found{batch.source_index(), 0, 0, std::vector<KernelFindings>(plan.kernels.size())};
  const std::uint64_t size = batch.source().fixed_size(precision_of<Real>).value_or(plan.trials);
  const std::uint64_t stride = plan.sample == 0 ? 0 : (size + plan.sample - 1) / plan.sample;
  std::vector<ByComparison> taken(plan.kernels.size());
  const auto search = [&](std::size_t i, AskedSphereTriangle<Real>& asked) {
    const std::uint64_t position = batch.position(i);
    std::optional<double> depth;
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      const Kernel& kernel = *plan.kernels[k];
      KernelFindings& findings = found.kernels[k];
      const Verdict verdict = batch.reply(k).verdicts[i];
      const ComparisonBits bits = batch.reply(k).answers.bits[i];
      const auto flips = static_cast<ComparisonBits>(bits ^ exact_bits(*asked.sides(kernel), kernel));
      for (std::size_t c = 0; c < comparison_count; ++c) findings.flips[c] += has_bit(flips, c);
      const bool sampled = stride != 0 && position % stride == 0;
      const Request request{position, within_limit(flips, plan.flip_limit, taken[k]),
                            sampled ? static_cast<ComparisonBits>(~flips) : ComparisonBits{0}};
      if (request.flips != 0 || request.others != 0) findings.requests.push_back(request);
      if (verdict == asked.truth().verdict || (verdict != Verdict::separated && verdict != Verdict::contact)) continue;
      ++(verdict == Verdict::separated ? findings.false_separation : findings.false_contact);
      if (!depth) depth = axiscert::depth(asked.query(), squared_distance(asked.query()));
      findings.wrong.push_back({*depth, position});
    }
  };
  found.invalid = for_each_valid(batch, search);
  found.valid = batch.size() - found.invalid;
  return found;
}

// Block by block, in the plan's order.
template <class Real>
std::vector<Findings> search_all(const ConditionPlan& plan, const ShowProgress& report) {
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, 512, plan.threads);
  take_whole_files(judged, plan.precision);
  judged.kernels = plan.kernels;
  judged.second_opinion_stride = second_opinion_stride;
  const auto visit = [&](JudgedBatch<Real>& batch, std::vector<Findings>& found) {
    found.push_back(search_block(plan, batch));
  };
  const auto append = [](std::vector<Findings>& found, std::vector<Findings>&& later) {
    std::ranges::move(later, std::back_inserter(found));
  };
  return for_each_judged<Real>(judged, std::vector<Findings>(), report, "flips are searched for", visit, append).counts;
}

// One evaluated request: its contribution to its cell.
struct EvaluatedRequest {
  EnumArray<Comparison, ConditionCounts> comparisons;
  std::vector<Decimal6> flip_kappa_u;
};

template <class Real>
EvaluatedRequest evaluate(const ConditionPlan& plan, const Kernel& kernel, const Source& source,
                          const Request& request) {
  using Kind = Condition::Kind;
  EvaluatedRequest result;
  const Query<Real> q = source.make<Real>(plan.seed, request.position);
  const auto found = conditions(formulae_of(kernel), q, static_cast<ComparisonBits>(request.flips | request.others));
  ComparisonBits range = 0;  // lost by the bounded exponent: R-infinity agrees with E, R does not
  if (request.flips != 0) {
    const RoundedDecisions chain = rounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q);
    const ComparisonBits exact = exact_bits(exact_sides(formulae_of(kernel), q), kernel);
    range = static_cast<ComparisonBits>(~(*chain.range_free.bits ^ exact) & (*chain.reference.bits ^ exact));
  }
  for (std::size_t i = 0; i < comparison_count; ++i) {
    ConditionCounts& counts = result.comparisons[i];
    const MeasuredValue measured{found[i].kappa_u, request.position};
    if (has_bit(request.others, i) && found[i].kind == Kind::finite) {
      ++counts.sampled;
      keep_greatest(counts.greatest_right, measured);
    }
    if (!has_bit(request.flips, i)) continue;
    ++counts.evaluated;
    counts.undefined += found[i].kind == Kind::undefined;
    counts.not_decided += found[i].kind == Kind::not_decided;
    counts.ties += found[i].kind == Kind::infinite;
    counts.ill_conditioned += found[i].ill_conditioned;
    if (found[i].kind != Kind::finite) continue;
    result.flip_kappa_u.push_back(measured.value);
    if (found[i].ill_conditioned) continue;
    ++counts.unstable;
    if (has_bit(range, i)) ++counts.range;
    else keep_least(counts.least_unstable, measured);
  }
  return result;
}

struct Job {
  std::size_t kernel, source;
  Request request;
};

void add_findings(const Findings& found, const ConditionPlan& plan, std::vector<std::vector<ByComparison>>& taken,
                  ConditionResult& result, std::vector<Job>& jobs) {
  const std::size_t source = found.source;
  result.valid[source] += found.valid;
  result.invalid[source] += found.invalid;
  for (std::size_t k = 0; k < found.kernels.size(); ++k) {
    const KernelFindings& findings = found.kernels[k];
    ConditionCell& cell = result.cells[k][source];
    for (std::size_t i = 0; i < comparison_count; ++i) cell.comparisons[i].flips += findings.flips[i];
    cell.false_separation += findings.false_separation;
    cell.false_contact += findings.false_contact;
    for (const WrongVerdict& wrong : findings.wrong) {
      cell.depths.push_back(wrong.depth);
      if (!cell.deepest || wrong.depth > cell.deepest->depth) cell.deepest = wrong;
    }
    for (Request request : findings.requests) {
      request.flips = within_limit(request.flips, plan.flip_limit, taken[k][source]);
      if (request.flips != 0 || request.others != 0) jobs.push_back({k, source, request});
    }
  }
}

template <class Real>
ConditionResult measure(const ConditionPlan& plan, const ShowProgress& report) {
  const std::vector<Findings> findings = search_all<Real>(plan, report);
  ConditionResult result;
  result.valid.resize(plan.sources.size());
  result.invalid.resize(plan.sources.size());
  result.cells.assign(plan.kernels.size(), std::vector<ConditionCell>(plan.sources.size()));
  result.flip_kappa_u.resize(plan.kernels.size());
  std::vector<std::vector<ByComparison>> taken(plan.kernels.size());
  for (auto& by_source : taken) by_source.resize(plan.sources.size());
  std::vector<Job> jobs;
  for (const Findings& found : findings) add_findings(found, plan, taken, result, jobs);

  std::vector<EvaluatedRequest> evaluated(jobs.size());
  ProgressCount conditioned(report, jobs.size(), "conditions");
  run_on_threads(plan.threads, [&] {
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
      const Job& job = jobs[i];
      evaluated[i] = evaluate<Real>(plan, *plan.kernels[job.kernel], *plan.sources[job.source], job.request);
      conditioned.finish_unit();
    });
  });
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    ConditionCell& cell = result.cells[jobs[i].kernel][jobs[i].source];
    axiscert::merge(cell.comparisons, evaluated[i].comparisons);
    auto& kappa_u = result.flip_kappa_u[jobs[i].kernel];
    kappa_u.insert(kappa_u.end(), evaluated[i].flip_kappa_u.begin(), evaluated[i].flip_kappa_u.end());
  }
  for (auto& by_source : result.cells) {
    for (ConditionCell& cell : by_source) std::sort(cell.depths.begin(), cell.depths.end());
  }
  for (auto& kappa_u : result.flip_kappa_u) std::sort(kappa_u.begin(), kappa_u.end());
  return result;
}

}  // namespace

ConditionCounts ConditionCell::total() const {
  ConditionCounts sum;
  for (const ConditionCounts& counts : comparisons) merge_fields(sum, counts);
  return sum;
}

ConditionResult measure_condition(const ConditionPlan& plan, const ShowProgress& report) {
  return plan.precision == Precision::binary32 ? measure<float>(plan, report) : measure<double>(plan, report);
}

}  // namespace axiscert
