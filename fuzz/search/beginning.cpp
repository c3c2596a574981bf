#include "fuzz/search/beginning.h"

#include <algorithm>

#include "fuzz/campaign/campaign.h"
#include "fuzz/search/pool.h"

namespace axiscert {
namespace {

// A query of the run by its place, with the severity of what it showed.
template <class Rank>
struct RankedPlace {
  Rank rank;
  const Source* source;
  std::uint64_t position;
};

template <class Rank>
void add(std::vector<RankedPlace<Rank>>& all, const Leaders<Rank>& leaders, const Source& source) {
  for (const auto& [rank, position] : leaders.candidates()) all.push_back({rank, &source, position});
}

// The most severe first; of equals the one whose source and position come first.
template <class Real, class Rank>
std::vector<Numbers<Real>> most_severe(std::vector<RankedPlace<Rank>> all, std::uint64_t seed) {
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.rank > y.rank; });
  all.resize(std::min(all.size(), Pool<Real>::capacity));
  std::vector<Numbers<Real>> queries;
  for (const auto& [rank, source, position] : all) queries.push_back(source->template make<Real>(seed, position));
  return queries;
}

}  // namespace

template <class Real>
Beginning<Real> first_found(const SearchPlan& plan, const std::vector<Aim>& aims,
                            const std::atomic<bool>& interrupted) {
  Beginning<Real> beginning{std::vector<std::vector<Numbers<Real>>>(aims.size()), {}};
  if (plan.first_queries == 0 || plan.first_sources.empty()) return beginning;
  Plan run;
  run.questions.seed = plan.seed;
  run.answerers.kernels = {plan.kernel};
  run.questions.sources = plan.first_sources;
  run.questions.precisions = {plan.precision};
  run.questions.trials = [&](const Source&, Precision) { return plan.first_queries; };
  run.running.target = plan.target;
  run.running.threads = plan.threads;
  const CampaignResult result = run_campaign(run, interrupted, {});
  for (const CellResult& cell : result.cells) merge_fields(beginning.looked_at, looked_at_of(cell.tallies.front()));
  for (std::size_t i = 0; i < aims.size(); ++i) {
    const Aim& aim = aims[i];
    std::vector<RankedPlace<double>> wrong;
    std::vector<RankedPlace<Decimal6>> errors;
    for (const CellResult& cell : result.cells) {
      const Source& source = *run.questions.sources[cell.source];
      const Tally& tally = cell.tallies.front();
      if (aim.goal == Goal::missed_contact || aim.goal == Goal::critical_radius) {
        add(wrong, tally.verdict.deepest_false_separation, source);
      }
      if (aim.goal == Goal::phantom_contact || aim.goal == Goal::critical_radius) {
        add(wrong, tally.verdict.deepest_false_contact, source);
      }
      if (aim.goal == Goal::error || aim.goal == Goal::relative_error) {
        add(errors, tally.comparisons[aim.which].largest_error, source);
      }
    }
    beginning.found[i] = is_about_a_comparison(aim.goal) ? most_severe<Real>(std::move(errors), plan.seed)
                                                         : most_severe<Real>(std::move(wrong), plan.seed);
  }
  return beginning;
}
template Beginning<float> first_found(const SearchPlan&, const std::vector<Aim>&, const std::atomic<bool>&);
template Beginning<double> first_found(const SearchPlan&, const std::vector<Aim>&, const std::atomic<bool>&);

}  // namespace axiscert
