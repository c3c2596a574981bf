// The precision in which a kernel computes, by the radii at which its answers turn.
#include <array>
#include <bit>
#include <cmath>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/queries/floats.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t turning_scenes = 64;
// The median error of a turning point, in ulps, for a kernel that computes in the query's own precision.
constexpr std::int64_t own_ulps = 256;

template <class Real>
using Word = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;

// The points of a query whose digits below binary32 are changed.
enum class ChangedPoints : std::uint8_t { vertices, centre, all_points };
constexpr std::array<ChangedPoints, 3> all_changes = {ChangedPoints::vertices, ChangedPoints::centre,
                                                      ChangedPoints::all_points};

// The same scene, as long as these points are read as floats.
Numbers<double> as_in_floats(const TurningScenes<double>& scenes, Numbers<double> query, ChangedPoints which) {
  for (std::size_t k = 0; k < query.size(); ++k) {
    const bool is_changed = (which != ChangedPoints::centre && scenes.is_of_first[k]) ||
                            (which != ChangedPoints::vertices && scenes.is_of_second[k]);
    if (!is_changed) continue;
    const double rounded = static_cast<double>(static_cast<float>(query[k]));
    query[k] = query[k] == rounded ? rounded * (1 + 0x1p-30) : rounded;
  }
  return query;
}

// The least radius, by bisection between 1 -+ 2^-10 of the distance, for which the kernel says contact; empty where it
// does not say separated and contact at the ends.
template <class Real>
std::vector<std::optional<Real>> turning_radii(Subject<Real>& subject, const Queries<Real>& scenes,
                                               std::size_t radius) {
  std::vector<Word<Real>> low, high;
  const auto with = [&](const std::vector<Word<Real>>& radii) {
    Queries<Real> queries = scenes;
    for (std::size_t i = 0; i < scenes.size(); ++i) queries[i][radius] = std::bit_cast<Real>(radii[i]);
    return subject.ask(queries);
  };
  for (const Numbers<Real>& q : scenes) {
    low.push_back(std::bit_cast<Word<Real>>(q[radius] * Real(1 - turning_range)));
    high.push_back(std::bit_cast<Word<Real>>(q[radius] * Real(1 + turning_range)));
  }
  const auto at_low = with(low), at_high = with(high);
  for (;;) {
    bool is_wide = false;
    std::vector<Word<Real>> middle = low;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      middle[i] = low[i] + (high[i] - low[i]) / 2;
      is_wide |= high[i] - low[i] > 1;
    }
    if (!is_wide) break;
    const auto said = with(middle);
    for (std::size_t i = 0; i < scenes.size(); ++i) (said[i] == Verdict::contact ? high : low)[i] = middle[i];
  }
  std::vector<std::optional<Real>> radii;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const bool turns = at_low[i] == Verdict::separated && at_high[i] == Verdict::contact;
    radii.push_back(turns ? std::optional(std::bit_cast<Real>(high[i])) : std::nullopt);
  }
  return radii;
}

struct TurningCounts {
  std::size_t answered = 0, exact = 0, early = 0, late = 0;
  std::size_t at_float = 0;            // between numbers that are different floats
  std::array<std::size_t, 3> same{};   // the same for other points that are the same floats, by Changed
  std::optional<std::int64_t> median;  // of the errors, in ulps; of none there is none
  bool is_of_floats() const { return at_float == answered || std::ranges::count(same, answered) != 0; }
  Json json() const {
    return {{"answered", answered},
            {"exact", exact},
            {"early", early},
            {"late", late},
            {"at_float", at_float},
            {"same_for_vertices_in_float", same[0]},
            {"same_for_centre_in_float", same[1]},
            {"same_for_points_in_float", same[2]},
            {"median_error_ulps", median ? Json(*median) : Json()}};
  }
};

template <class Real>
ProbeFinding concluded(Subject<Real>& subject, const TurningScenes<Real>& scenes, const TurningCounts& counts,
                       std::optional<DiagnosisWitness> witness) {
  const Json measured = counts.json();
  std::vector<DiagnosisWitness> witnesses;
  if (witness) witnesses.push_back(*witness);
  if (2 * counts.answered < turning_scenes) {
    return undecided(fmt::format("Of {} scenes its answer turns near the distance for {}: too few to say.",
                                 turning_scenes, counts.answered),
                     measured);
  }
  if (sizeof(Real) == 8 && counts.is_of_floats()) {
    return decided(
        Inner::narrower,
        fmt::format("Something in it is binary32: of {} scenes its answer turns where the radius becomes "
                    "another float in {}, and does not change with what floats cannot hold of {} in {}, of {} "
                    "in {}.",
                    counts.answered, counts.at_float, scenes.first, counts.same[0], scenes.second, counts.same[1]),
        std::move(witnesses), measured);
  }
  if (counts.exact == counts.answered) {
    return decided(Inner::wider,
                   fmt::format("It computes with more digits than the query has, or exactly: its answer "
                               "turns at the exact radius, to the last bit, in {} of {} scenes.",
                               counts.exact, counts.answered),
                   std::move(witnesses), measured);
  }
  if (counts.early >= 3 && counts.late >= 3 && *counts.median <= own_ulps) {
    // A float kernel shows the same where a computation in double stops early; its roundings show in their order.
    const std::string order = sizeof(Real) == 4 ? operation_order(subject).value : std::string();
    if (order == not_asked) {
      return undecided(
          fmt::format("Its answer turns too early in {} and too late in {} of {} scenes; in this predicate no "
                      "order of operations is asked, by which these would be roundings.",
                      counts.early, counts.late, counts.answered),
          measured);
    }
    if (order == not_known) {
      return undecided(fmt::format("Its answer turns too early in {} and too late in {} of {} scenes, but no order of "
                                   "operations is seen by which these would be roundings.",
                                   counts.early, counts.late, counts.answered),
                       measured);
    }
    return decided(Inner::own,
                   fmt::format("It computes in the query's precision: its answer turns too early in {} and "
                               "too late in {} of {} scenes, by {} ulps in the median.",
                               counts.early, counts.late, counts.answered, *counts.median),
                   std::move(witnesses), measured);
  }
  return undecided(fmt::format("Its answer turns too early in {} and too late in {} of {} scenes, by {} ulps in the "
                               "median: rounding in one precision does not do that alone.",
                               counts.early, counts.late, counts.answered, *counts.median),
                   measured);
}

}  // namespace

template <class Real>
ProbeFinding inner_precision(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  if (!oracles_of(kernel).critical_length())
    return unasked("Queries of this entry have no radius at which the answer turns, by which digits are seen.");
  const TurningScenes<Real> scenes = scenes_of<Real>(*kernel.predicate).turning(subject, turning_scenes);
  if (scenes.why_none) return undecided(*scenes.why_none);
  const std::size_t radius = scenes.radius;
  const auto radii = turning_radii(subject, scenes.queries, radius);
  std::array<std::vector<std::optional<Real>>, 3> of_floats;  // by Changed
  if constexpr (sizeof(Real) == 8) {
    for (const ChangedPoints which : all_changes) {
      Queries<Real> changed;
      for (const auto& q : scenes.queries) changed.push_back(as_in_floats(scenes, q, which));
      of_floats[static_cast<std::size_t>(which)] = turning_radii(subject, changed, radius);
    }
  }
  TurningCounts counts;
  std::vector<std::int64_t> errors;
  std::optional<DiagnosisWitness> witness;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    if (!radii[i]) continue;
    ++counts.answered;
    Numbers<Real> at = scenes.queries[i], before = at;
    const Real distance = at[radius];
    at[radius] = *radii[i];
    before[radius] = step_radius(at[radius], -1);
    const bool is_early = subject.truth(at).verdict == Verdict::separated;
    const bool is_late = subject.truth(before).verdict == Verdict::contact;
    counts.early += is_early;
    counts.late += is_late;
    counts.exact += !is_early && !is_late;
    counts.at_float += static_cast<float>(at[radius]) != static_cast<float>(before[radius]);
    for (std::size_t k = 0; k < 3 && sizeof(Real) == 8; ++k) counts.same[k] += of_floats[k][i] == radii[i];
    errors.push_back(std::abs(std::int64_t{std::bit_cast<Word<Real>>(at[radius])} -
                              std::int64_t{std::bit_cast<Word<Real>>(distance)}));
    if (!witness && (is_early || is_late || i + 1 == radii.size())) {
      witness = subject.witness(is_late ? before : at, is_late ? Verdict::separated : Verdict::contact,
                                "the radius at which the answer turns, or the one before");
    }
  }
  std::sort(errors.begin(), errors.end());
  if (!errors.empty()) counts.median = errors[errors.size() / 2];
  return concluded(subject, scenes, counts, witness);
}
template ProbeFinding inner_precision(Subject<float>&);
template ProbeFinding inner_precision(Subject<double>&);

}  // namespace axiscert::diagnosis
