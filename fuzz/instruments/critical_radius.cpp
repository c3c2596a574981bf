#include "fuzz/instruments/critical_radius.h"

#include <algorithm>
#include <cmath>

#include "exact/judge/critical_radius.h"
#include "exact/judge/oracles.h"
#include "fuzz/files/query_file.h"
#include "fuzz/instruments/for_each_judged.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/merge.h"
#include "kernel/query.h"

namespace axiscert {
namespace {

template <class Real>
ReversalWitness witness_of(const RadiusReversal<Real>& reversal, QueryWithRadius<Real> q, const Source& source,
                           std::string address, std::uint64_t position) {
  const auto line = [&](Real radius, const char* answer) {
    q.numbers[q.column] = radius;
    return query_line({address + " " + answer, precision_of<Real>, q.numbers, &source.predicate(), source.entry()});
  };
  return {position, line(reversal.contact, "contact"), line(reversal.separated, "separated")};
}

// The radii that the kernel promises anything about; empty where the query at its exact critical radius is none such.
template <class Real>
std::optional<RadiusRange<Real>> promised_radii(const Kernel& kernel, QueryWithRadius<Real> q, Real exact_radius) {
  const Oracles& oracles = oracles_of(kernel);
  if (!oracles.has_limits() || !kernel.limits.any()) return RadiusRange<Real>{};
  q.numbers[q.column] = exact_radius;
  if (!oracles.is_within(kernel.limits, q.numbers)) return std::nullopt;
  return radii_within<Real>(kernel.limits);
}

template <class Real>
void measure(const Kernel& of, const Implementation<Real>& kernel, const QueryWithRadius<Real>& q,
             const Rational& squared_distance, Real exact_radius, const Source& source, const Address& address,
             CriticalRadii& cell) {
  const std::uint64_t position = address.position();
  const auto range = promised_radii(of, q, exact_radius);
  if (!range) {
    ++cell.outside_limits;
    return;
  }
  const auto critical = critical_radius(kernel, q, *range);
  if (!critical.answered) {
    ++cell.unanswered;
    return;
  }
  if (critical.not_decided) {
    ++(*critical.not_decided == Verdict::invalid ? cell.invalid : cell.undecided);
    return;
  }
  ++cell.measured;
  const auto& radius = critical.radius;
  if (!radius) {
    ++cell.unbounded;
  } else {
    const Decimal6 error = radius_error_ulps(*radius, exact_radius, squared_distance);
    ++cell.errors[error];
    if (*radius < exact_radius) {
      ++cell.early;
      keep_greatest(cell.worst_early, {error, position});
    } else if (*radius > exact_radius) {
      ++cell.late;
      keep_greatest(cell.worst_late, {error, position});
    } else {
      ++cell.right;
    }
  }
  const auto is_promised = [&](Real r) { return r >= range->least && r <= range->greatest; };
  if (const auto reversal = radius_reversal<Real>(kernel, q, radius, exact_radius);
      reversal && is_promised(reversal->contact) && is_promised(reversal->separated)) {
    ++cell.reversals;
    if (!cell.first_reversal) cell.first_reversal = witness_of(*reversal, q, source, text(address), position);
  }
}

// Finite numbers, and a radius that is not negative.
template <class Real>
bool is_measurable(const QueryWithRadius<Real>& q) {
  return q.numbers[q.column] >= 0 &&
         std::all_of(q.numbers.begin(), q.numbers.end(), [](Real x) { return std::isfinite(x); });
}

template <class Real>
void measure_batch(const CriticalRadiusPlan& plan, JudgedBatch<Real>& batch, CriticalRadiusResult& result) {
  const CriticalLength length = *batch.oracles().critical_length();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const QueryWithRadius<Real> q = {batch[i], length.column};
    batch.count_progress();
    std::optional<Rational> squared;
    std::optional<Real> exact_radius;
    if (is_measurable(q)) {
      squared = length.squared(in_doubles(q.numbers));
      if (squared) exact_radius = sqrt_rounded_up<Real>(*squared);
    }
    if (!exact_radius) {
      ++result.left_out[batch.source_index()];
      continue;
    }
    const Address address = address_of(batch.source(), plan.seed, plan.precision, batch.position(i));
    for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
      measure(*plan.kernels[k], batch.kernel(k), q, *squared, *exact_radius, batch.source(), address,
              result.cells[k][batch.source_index()]);
    }
  }
}

template <class Real>
CriticalRadiusResult measure_all(const CriticalRadiusPlan& plan, const ShowProgress& report) {
  JudgedPlan judged = judged_plan(plan.sources, plan.trials, plan.seed, 256, plan.threads);
  for (std::size_t i = 0; i < judged.sources.size(); ++i)
    judged.trials[i] = judged.sources[i]->fixed_size(plan.precision).value_or(plan.trials);
  judged.kernels = plan.kernels;
  CriticalRadiusResult none;
  none.left_out.resize(plan.sources.size());
  none.cells.assign(plan.kernels.size(), std::vector<CriticalRadii>(plan.sources.size()));
  const auto visit = [&](JudgedBatch<Real>& batch, CriticalRadiusResult& result) {
    measure_batch(plan, batch, result);
  };
  return for_each_judged<Real>(judged, none, report, {}, visit, merge_fields<CriticalRadiusResult>).counts;
}

}  // namespace

std::optional<Decimal6> CriticalRadii::quantile(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(measured)));
  std::uint64_t reached = 0;
  for (const auto& [error, count] : errors) {
    reached += count;
    if (reached >= wanted) return error;
  }
  return std::nullopt;
}

std::uint64_t CriticalRadii::within(const Decimal6& error) const {
  std::uint64_t count = 0;
  for (auto it = errors.begin(); it != errors.end() && it->first <= error; ++it) count += it->second;
  return count;
}

CriticalRadiusResult measure_critical_radii(const CriticalRadiusPlan& plan, const ShowProgress& report) {
  return plan.precision == Precision::binary32 ? measure_all<float>(plan, report) : measure_all<double>(plan, report);
}

}  // namespace axiscert
