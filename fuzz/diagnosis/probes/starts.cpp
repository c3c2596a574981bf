// The answers of a kernel of motions where the two have a point in common before the motion.
#include <array>

#include "fuzz/diagnosis/probes/probes.h"
#include "fuzz/diagnosis/probes/tallied.h"
#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/diagnosis/scenes/scenes_by_trait.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t starts_of_each = 48, least_starts = 16;
constexpr std::uint64_t start_positions = 16384;

// Queries that overlap before the motion, clear of touching then and on the whole way.
template <class Real>
struct OverlappingStarts {
  Queries<Real> approaching, leaving, still;  // the distance falls at first; it does not; nothing moves
};

template <class Real>
OverlappingStarts<Real> overlapping_starts(Subject<Real>& subject) {
  OverlappingStarts<Real> found;
  const Kernel& kernel = subject.kernel();
  const Oracles& oracles = oracles_of(kernel);
  const Family* family = family_named_general(kernel);
  const MotionPolicy approaching{.start = StartPolicy::approaching};
  for (std::uint64_t i = 0; family && i < start_positions; ++i) {
    if (std::min(found.approaching.size(), found.leaving.size()) >= starts_of_each) break;
    const Numbers<Real> query = family->make<Real>(subject.seed(), i), still = without_motion(kernel, query);
    if (!is_plump(kernel, query)) continue;
    if (oracles.truth(still).verdict != Verdict::contact || !(oracles.depth(still) > clear_depth)) continue;
    Queries<Real>& into = oracles.is_promised(approaching, query) ? found.approaching : found.leaving;
    if (into.size() < starts_of_each) into.push_back(query);
    if (found.still.size() < starts_of_each) found.still.push_back(still);
  }
  return found;
}

}  // namespace

template <class Real>
ProbeFinding overlap_at_start(Subject<Real>& subject) {
  if (!is_of_motions(subject.predicate())) return unasked("Nothing moves in this predicate.");
  const OverlappingStarts<Real> starts = overlapping_starts(subject);
  const std::array<const Queries<Real>*, 3> groups = {&starts.approaching, &starts.leaving, &starts.still};
  constexpr std::array<std::string_view, 3> names = {"approaching", "leaving", "still"};
  std::array<TalliedVerdicts, 3> said;
  std::vector<DiagnosisWitness> witnesses;
  Json measured = Json::object();
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const std::vector<Verdict> answers = subject.ask(*groups[k]);
    std::optional<std::size_t> shown;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (!is_decided(answers[i])) continue;
      said[k].add(answers[i]);
      if (!shown || (answers[*shown] == Verdict::contact && answers[i] == Verdict::separated)) shown = i;
    }
    measured[std::string(names[k])] = said[k].json();
    if (shown)
      witnesses.push_back(subject.witness((*groups[k])[*shown], answers[*shown],
                                          fmt::format("an overlap before the motion, {}", names[k])));
  }
  const auto always = [&](std::size_t k) { return said[k].all() >= least_starts && said[k].separated == 0; };
  const auto never = [&](std::size_t k) { return said[k].all() >= least_starts && said[k].contact == 0; };
  const std::string counts =
      fmt::format("contact on {} of {} that approach, {} of {} that leave, {} of {} that do not move", said[0].contact,
                  said[0].all(), said[1].contact, said[1].all(), said[2].contact, said[2].all());
  // Queries without a motion may be declined: then the other two decide.
  const bool is_still_declined = said[2].all() == 0;
  if (always(0) && always(1) && (always(2) || is_still_declined))
    return decided(Starts::reported, "It reports an overlap before the motion: " + counts + ".", std::move(witnesses),
                   measured);
  if (always(0) && always(1) && never(2))
    return decided(Starts::moving,
                   "It reports an overlap before a motion, but none where nothing moves: " + counts + ".",
                   std::move(witnesses), measured);
  if (always(0) && never(1))
    return decided(Starts::approaching,
                   "It misses an overlap before the motion unless the distance falls at first: " + counts + ".",
                   std::move(witnesses), measured);
  if (never(0) && never(1))
    return decided(Starts::ignored, "It misses every overlap before the motion: " + counts + ".", std::move(witnesses),
                   measured);
  return undecided(fmt::format("Of overlaps before the motion it says {}: no rule.", counts), measured);
}
template ProbeFinding overlap_at_start(Subject<float>&);
template ProbeFinding overlap_at_start(Subject<double>&);

}  // namespace axiscert::diagnosis
