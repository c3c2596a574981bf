// The sides of a triangle from which a kernel hits it.
#include <array>

#include "fuzz/diagnosis/probes/probes.h"
#include "fuzz/diagnosis/probes/tallied.h"
#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/diagnosis/scenes/scenes_by_trait.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t sided_count = 128, least_of_each_side = 16;

// Whether it says separated on nine in ten of the queries that clearly are: else it says contact whatever the side.
template <class Real>
bool separates(Subject<Real>& subject) {
  Queries<Real> apart;
  for (const auto& query : clear_queries<Real>(subject.kernel(), 128)) {
    if (query.truth == Verdict::separated) apart.push_back(query.numbers);
  }
  const auto said = subject.ask(apart);
  return !apart.empty() && 10 * std::ranges::count(said, Verdict::separated) >= 9 * std::ssize(said);
}

}  // namespace

template <class Real>
ProbeFinding sides_hit(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  if (!vertex_columns(kernel)) return unasked("This predicate has no triangle that could be hit from one side.");
  const SidedScenes<Real> scenes = scenes_of<Real>(*kernel.predicate).sided(subject, sided_count);
  Queries<Real> hits;
  for (const auto& scene : scenes.queries) hits.push_back(scene.query);
  if (scenes.apart.empty() && !separates(subject))
    return undecided("It says contact on queries that are far from it: its contacts say nothing of sides.");
  const auto said = subject.ask(hits);
  // A scene whose answer is the same where it is known to be apart says nothing.
  const auto of_apart = scenes.apart.empty() ? std::vector(hits.size(), Verdict::separated) : subject.ask(scenes.apart);
  TalliedVerdicts front, back;
  std::array<std::optional<std::size_t>, 2> first, first_missed;  // back, front
  std::size_t answered = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (of_apart[i] != Verdict::separated || !is_decided(said[i])) continue;
    ++answered;
    const bool is_front = scenes.queries[i].is_front;
    (is_front ? front : back).add(said[i]);
    auto& kept = (said[i] == Verdict::contact ? first : first_missed)[is_front];
    if (!kept) kept = i;
  }
  const Json measured = {{"front", front.json()}, {"back", back.json()}};
  std::vector<DiagnosisWitness> witnesses;
  for (const bool is_front : {true, false}) {
    const std::string side(is_front ? scenes.front : scenes.behind);
    if (first[is_front]) witnesses.push_back(subject.witness(hits[*first[is_front]], Verdict::contact, side));
    if (first_missed[is_front])
      witnesses.push_back(subject.witness(hits[*first_missed[is_front]], Verdict::separated, side));
  }
  const std::string counts = fmt::format("{} of {} {} in front of a face and {} of {} behind one", front.contact,
                                         front.all(), scenes.what, back.contact, back.all());
  const bool is_answered = 4 * answered >= 3 * hits.size() && std::min(front.all(), back.all()) >= least_of_each_side;
  if (is_answered && front.separated == 0 && back.separated == 0) {
    return decided(Sides::both, "It hits triangles from both sides: " + counts + ".", std::move(witnesses), measured);
  }
  if (is_answered && front.separated == 0 && back.contact == 0) {
    return decided(Sides::front_only,
                   fmt::format("It is one-sided: {} behind the face, seen from where A, B, C run counterclockwise, is "
                               "never a contact: {}.",
                               scenes.whose, counts),
                   std::move(witnesses), measured);
  }
  if (is_answered && front.contact == 0 && back.separated == 0) {
    return decided(Sides::back_only,
                   fmt::format("It is one-sided: {} in front of the face, where A, B, C run counterclockwise, is never "
                               "a contact: {}.",
                               scenes.whose, counts),
                   std::move(witnesses), measured);
  }
  return undecided(fmt::format("It says contact on {}, all of which are contacts: no rule of sides.", counts),
                   measured);
}
template ProbeFinding sides_hit(Subject<float>&);
template ProbeFinding sides_hit(Subject<double>&);

}  // namespace axiscert::diagnosis
