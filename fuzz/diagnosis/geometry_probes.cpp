// Answers of a kernel about spheres that touch, about the two sides of a triangle, and about triangles without area.
#include <array>

#include "fuzz/diagnosis/clear_queries.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "kernel/base/error.h"

namespace axiscert::diagnosis {
namespace {

// Beyond rounding where the numbers are small integers, and within the slack of what stops at a tolerance.
constexpr double near_touching = 0x1p-16;
constexpr std::size_t touching_of_each = 32, sided_count = 128, flat_of_each = 64;
// Answers that have to be there, as a share of those that were asked for.
constexpr bool are_enough(std::size_t found, std::size_t asked) { return 4 * found >= 3 * asked; }

template <class Real>
Queries<Real> with_radius_times(const auto& scenes, Real factor) {
  Queries<Real> queries;
  for (const auto& scene : scenes) {
    Query<Real> q = scene.query;
    q.r *= factor;
    queries.push_back(q);
  }
  return queries;
}

// Contacts and separations by a group of scenes.
struct Tallied {
  std::size_t contact = 0, separated = 0, other = 0;
  void add(Verdict v) { ++(v == Verdict::contact ? contact : v == Verdict::separated ? separated : other); }
  Json json() const { return {{"contact", contact}, {"separated", separated}}; }
};

}  // namespace

template <class Real>
Found at_touching(Subject<Real>& subject) {
  const auto scenes = touching_scenes<Real>(subject.seed(), touching_of_each);
  const Queries<Real> touching = with_radius_times<Real>(scenes, 1);
  const auto said = subject.ask(touching), smaller = subject.ask(with_radius_times<Real>(scenes, Real(0.5))),
             larger = subject.ask(with_radius_times<Real>(scenes, Real(1.5)));
  std::array<Tallied, 3> parts;
  std::optional<std::size_t> contact, apart;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (!subject.truth(touching[i]).touching) throw HarnessFault("diagnosis: a scene that is to touch does not");
    // A scene whose answer does not turn from half the distance to one and a half says nothing of touching.
    if (smaller[i] != Verdict::separated || larger[i] != Verdict::contact || !is_decided(said[i])) continue;
    ++counted;
    parts[static_cast<std::size_t>(scenes[i].part)].add(said[i]);
    std::optional<std::size_t>& first = said[i] == Verdict::contact ? contact : apart;
    if (!first) first = i;
  }
  const Json measured = {{"face", parts[0].json()}, {"edge", parts[1].json()}, {"vertex", parts[2].json()}};
  if (!are_enough(counted, scenes.size())) {
    return undecided(fmt::format("It answers {} of {} spheres that touch, and is right on the same spheres with half "
                                 "the radius and half as much again: too few to say.",
                                 counted, scenes.size()),
                     measured);
  }
  std::vector<DiagnosisWitness> witnesses;
  if (contact) witnesses.push_back(subject.witness(touching[*contact], Verdict::contact, "the distance is the radius"));
  if (apart) witnesses.push_back(subject.witness(touching[*apart], Verdict::separated, "the distance is the radius"));
  if (!apart || !contact) {
    // A convention turns there; a slack or a tolerance turns elsewhere.
    const bool is_closed = !apart;
    const auto nearby = subject.ask(
        with_radius_times<Real>(scenes, static_cast<Real>(is_closed ? 1 - near_touching : 1 + near_touching)));
    const auto turned =
        static_cast<std::size_t>(std::ranges::count(nearby, is_closed ? Verdict::separated : Verdict::contact));
    const char* said_there = is_closed ? "contact" : "separated";
    if (!are_enough(turned, scenes.size())) {
      return undecided(fmt::format("At a distance of exactly r it says {}, and so it does of {} of {} spheres whose "
                                   "radius is {} by a part in 65536: a slack, and no convention.",
                                   said_there, scenes.size() - turned, scenes.size(), is_closed ? "less" : "more"),
                       measured);
    }
    return decided(is_closed ? AtTouching::closed : AtTouching::open,
                   fmt::format("The sphere is {}: at a distance of exactly r it says {}, {} times of {}.",
                               is_closed ? "closed" : "open", said_there, counted, counted),
                   std::move(witnesses), measured);
  }
  return decided(AtTouching::neither,
                 fmt::format("At a distance of exactly r it says contact {} times and separated {} times, although "
                             "hardly an operation is rounded.",
                             parts[0].contact + parts[1].contact + parts[2].contact,
                             parts[0].separated + parts[1].separated + parts[2].separated),
                 std::move(witnesses), measured);
}

template <class Real>
Found sides_hit(Subject<Real>& subject) {
  const auto scenes = sided_scenes<Real>(subject.seed(), sided_count);
  const Queries<Real> hits = with_radius_times<Real>(scenes, 1);
  const auto said = subject.ask(hits), smaller = subject.ask(with_radius_times<Real>(scenes, Real(0.25)));
  Tallied front, back;
  std::array<std::optional<std::size_t>, 2> first, first_missed;  // back, front
  std::size_t answered = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (smaller[i] != Verdict::separated || !is_decided(said[i])) continue;
    ++answered;
    (scenes[i].is_front ? front : back).add(said[i]);
    auto& kept = (said[i] == Verdict::contact ? first : first_missed)[scenes[i].is_front];
    if (!kept) kept = i;
  }
  const Json measured = {{"front", front.json()}, {"back", back.json()}};
  std::vector<DiagnosisWitness> witnesses;
  for (const bool is_front : {true, false}) {
    const char* side = is_front ? "the centre is in front of the face, at half the radius"
                                : "the centre is behind the face, at half the radius";
    if (first[is_front]) witnesses.push_back(subject.witness(hits[*first[is_front]], Verdict::contact, side));
    if (first_missed[is_front])
      witnesses.push_back(subject.witness(hits[*first_missed[is_front]], Verdict::separated, side));
  }
  const std::string counts = fmt::format("{} of {} spheres in front of a face and {} of {} behind one", front.contact,
                                         front.contact + front.separated, back.contact, back.contact + back.separated);
  const bool is_answered =
      are_enough(answered, scenes.size()) && front.contact + front.separated != 0 && back.contact + back.separated != 0;
  if (is_answered && front.separated == 0 && back.separated == 0) {
    return decided(Sides::both, "It hits triangles from both sides: " + counts + ".", std::move(witnesses), measured);
  }
  if (is_answered && front.separated == 0 && back.contact == 0) {
    return decided(Sides::front_only,
                   "It is one-sided: a sphere whose centre is behind the face, seen from where A, B, C run "
                   "counterclockwise, is never a contact: " +
                       counts + ".",
                   std::move(witnesses), measured);
  }
  if (is_answered && front.contact == 0 && back.separated == 0) {
    return decided(Sides::back_only,
                   "It is one-sided: a sphere whose centre is in front of the face, where A, B, C run "
                   "counterclockwise, is never a contact: " +
                       counts + ".",
                   std::move(witnesses), measured);
  }
  return undecided("It says contact on " + counts + ", all of which overlap the face: no rule of sides.", measured);
}

namespace {

struct FlatCounts {
  std::size_t right = 0, hit = 0, missed = 0, refused = 0, unanswered = 0;
  std::size_t all() const { return right + hit + missed + refused + unanswered; }
  // Among as many contacts as separations: all of one kind wrong, and none of the other.
  std::optional<Degenerate> value() const {
    if (unanswered * 10 > all()) return std::nullopt;
    if (refused == all()) return Degenerate::refused;
    if (refused == 0 && hit == 0 && missed == 0) return Degenerate::handled;
    if (missed * 2 == all() && hit == 0) return Degenerate::skipped;
    if (hit * 2 == all() && missed == 0) return Degenerate::always_hit;
    return Degenerate::wrong_on_some;
  }
  Json json() const {
    const auto found = value();
    return {{"value", found ? name(*found) : not_known},
            {"right", right},
            {"phantom_contacts", hit},
            {"missed_contacts", missed},
            {"refused", refused}};
  }
};

std::string flat_sentence(Degenerate value) {
  switch (value) {
    case Degenerate::handled:
      return "Triangles without area are handled: a point, two equal vertices, three on a line, all answered rightly.";
    case Degenerate::skipped:
      return "Triangles without area are skipped: they never touch anything.";
    case Degenerate::always_hit:
      return "Triangles without area are always hit, however far away the sphere is.";
    case Degenerate::refused:
      return "Triangles without area are refused: the answer is invalid.";
    case Degenerate::wrong_on_some:
      break;
  }
  return "Triangles without area are neither handled nor skipped: it is wrong on some of them.";
}

}  // namespace

template <class Real>
Found degenerate_triangles(Subject<Real>& subject) {
  if (const auto why = why_not_sound(subject)) return undecided(*why);
  const auto scenes = flat_scenes<Real>(subject.seed(), flat_of_each);
  const Queries<Real> queries = with_radius_times<Real>(scenes, 1);
  const auto said = subject.ask(queries);
  std::array<FlatCounts, 3> kinds;
  std::optional<std::size_t> phantom, missed, right;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    FlatCounts& counts = kinds[static_cast<std::size_t>(scenes[i].flat)];
    const Verdict truth = scenes[i].is_contact ? Verdict::contact : Verdict::separated;
    if (subject.truth(queries[i]).verdict != truth) throw HarnessFault("diagnosis: a flat scene is not as it is made");
    if (said[i] == Verdict::invalid) ++counts.refused;
    else if (!is_decided(said[i])) ++counts.unanswered;
    else if (said[i] == truth) {
      ++counts.right;
      if (!right) right = i;
    } else {
      ++(scenes[i].is_contact ? counts.missed : counts.hit);
      std::optional<std::size_t>& first = scenes[i].is_contact ? missed : phantom;
      if (!first) first = i;
    }
  }
  Json measured = Json::object();
  bool same = true, known = true;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    measured[std::string(flat_names[k])] = kinds[k].json();
    known = known && kinds[k].value().has_value();
    same = same && kinds[k].value() == kinds[0].value();
  }
  if (!known) return undecided("It leaves triangles without area undecided, or gives no answer.", measured);
  std::vector<DiagnosisWitness> witnesses;
  const auto show = [&](const std::optional<std::size_t>& i, const char* what) {
    if (i) witnesses.push_back(subject.witness(queries[*i], said[*i], what));
  };
  show(phantom, "the triangle has no area, and is far away");
  show(missed, "the triangle has no area, and is well inside the sphere");
  if (witnesses.empty()) show(right, "the triangle has no area");
  const Degenerate value = same ? *kinds[0].value() : Degenerate::wrong_on_some;
  return decided(value, flat_sentence(value), std::move(witnesses), measured);
}

#define AXISCERT_INSTANCES(Real)              \
  template Found at_touching(Subject<Real>&); \
  template Found sides_hit(Subject<Real>&);   \
  template Found degenerate_triangles(Subject<Real>&);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
