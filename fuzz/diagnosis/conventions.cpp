// The probes of conventions: at touching, on the two sides of a triangle, and at the start of a motion.
#include <array>
#include <cctype>
#include <cstddef>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/diagnosis/scenes_by_trait.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "kernel/names.h"

namespace axiscert::diagnosis {
// Contacts and separations by a group of scenes.
struct TalliedVerdicts {
  std::size_t contact = 0, separated = 0, other = 0;
  void add(Verdict v) { ++(v == Verdict::contact ? contact : v == Verdict::separated ? separated : other); }
  std::size_t all() const { return contact + separated; }  // decided
  Json json() const { return {{"contact", contact}, {"separated", separated}}; }
};

// The answer of a kernel at touching.

namespace {

// Beyond rounding where the numbers are small integers, and within the slack of what stops at a tolerance.
constexpr double near_touching = 0x1p-16;
constexpr std::size_t touching_count = 96;

std::string capitalised(std::string_view text) {
  std::string capital(text);
  capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(capital[0])));
  return capital;
}

}  // namespace

template <class Real>
ProbeFinding at_touching(Subject<Real>& subject) {
  const Kernel& kernel = subject.kernel();
  if (!has_lengths(kernel))
    return unasked("No length of this entry could grow, by which touching is told from a slack.");
  const TouchingScenes<Real> scenes = scenes_of<Real>(*kernel.predicate).touching(subject, touching_count);
  const Queries<Real>& touching = scenes.queries;
  if (touching.empty())
    return unasked("No family of this entry touches without a rounding where the kernel promises an answer.");
  const auto times = [&](double factor) {
    Queries<Real> queries;
    for (const Numbers<Real>& query : touching)
      queries.push_back(with_lengths_times(kernel, query, static_cast<Real>(factor)));
    return queries;
  };
  const auto said = subject.ask(touching), smaller = subject.ask(times(0.5)), larger = subject.ask(times(1.5));
  std::vector<TalliedVerdicts> parts(scenes.parts.size());
  TalliedVerdicts all;
  std::optional<std::size_t> contact, apart;
  std::size_t counted = 0;
  std::vector<bool> is_counted(touching.size());
  for (std::size_t i = 0; i < touching.size(); ++i) {
    if (!subject.truth(touching[i]).touching) throw HarnessFault("diagnosis: a scene that is to touch does not");
    // A scene whose answer does not turn from half the distance to one and a half says nothing of touching.
    if (smaller[i] != Verdict::separated || larger[i] != Verdict::contact || !is_decided(said[i])) continue;
    ++counted;
    is_counted[i] = true;
    parts[scenes.part[i]].add(said[i]);
    all.add(said[i]);
    std::optional<std::size_t>& first = said[i] == Verdict::contact ? contact : apart;
    if (!first) first = i;
  }
  Json measured = Json::object();
  for (std::size_t k = 0; k < parts.size(); ++k) measured[std::string(scenes.parts[k])] = parts[k].json();
  if (counted < scenes.least) {
    return undecided(fmt::format("Of {} {} that touch it answers {}, and rightly with half the {} and half as much "
                                 "again: too few to say.",
                                 touching.size(), scenes.what, counted, scenes.length),
                     measured);
  }
  std::vector<DiagnosisWitness> witnesses;
  const std::string shows(scenes.touches);
  if (contact) witnesses.push_back(subject.witness(touching[*contact], Verdict::contact, shows));
  if (apart) witnesses.push_back(subject.witness(touching[*apart], Verdict::separated, shows));
  const std::string where = capitalised(scenes.where);
  if (apart && contact) {
    return decided(AtTouching::neither,
                   fmt::format("{} it says contact {} times and separated {} times, although hardly an operation is "
                               "rounded.",
                               where, all.contact, all.separated),
                   std::move(witnesses), measured);
  }
  // A convention turns there; a slack or a tolerance turns elsewhere.
  const bool is_closed = !apart;
  const auto nearby = subject.ask(times(is_closed ? 1 - near_touching : 1 + near_touching));
  std::size_t turned = 0;
  for (std::size_t i = 0; i < nearby.size(); ++i)
    turned +=
        (scenes.all_tell_of_slack || is_counted[i]) && nearby[i] == (is_closed ? Verdict::separated : Verdict::contact);
  const char* said_there = is_closed ? "contact" : "separated";
  const std::size_t of = scenes.all_tell_of_slack ? touching.size() : counted;
  if (4 * turned < 3 * of) {
    return undecided(
        fmt::format("{} it says {}, and so it does of {} of {} {} whose {} is {} by a part in 65536: a "
                    "slack, and no convention.",
                    where, said_there, of - turned, of, scenes.what, scenes.length, is_closed ? "less" : "more"),
        measured);
  }
  return decided(is_closed ? AtTouching::closed : AtTouching::open,
                 fmt::format("{} is {}: {} it says {}, {} times of {}.", scenes.whole, is_closed ? "closed" : "open",
                             scenes.where, said_there, counted, counted),
                 std::move(witnesses), measured);
}
template ProbeFinding at_touching(Subject<float>&);
template ProbeFinding at_touching(Subject<double>&);

// The sides of a triangle from which a kernel hits it.

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

// The answers of a kernel of motions where the two have a point in common before the motion.

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
