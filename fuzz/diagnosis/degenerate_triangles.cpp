// The answers of a kernel on triangles without area.
#include <array>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/diagnosis/scenes_by_trait.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"

namespace axiscert::diagnosis {
namespace {

constexpr std::size_t flat_of_each = 64, least_of_each = 16;

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
ProbeFinding degenerate_triangles(Subject<Real>& subject) {
  if (!vertex_columns(subject.kernel())) return unasked("This predicate has no triangle.");
  if (const auto why = why_not_sound(subject)) return undecided(*why);
  const FlatScenes<Real> flat = scenes_of<Real>(subject.predicate()).flat(subject, flat_of_each);
  const std::vector<FlatQuery<Real>>& scenes = flat.queries;
  Queries<Real> queries;
  for (const auto& scene : scenes) queries.push_back(scene.query);
  for (const Flat kind : {Flat::point, Flat::two_equal, Flat::collinear}) {
    if (std::ranges::count(scenes, kind, &FlatQuery<Real>::flat) < std::ptrdiff_t{least_of_each})
      return unasked("Too few triangles without area were made on which the kernel promises an answer.");
  }
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
  const auto show = [&](const std::optional<std::size_t>& i, const std::string& what) {
    if (i) witnesses.push_back(subject.witness(queries[*i], said[*i], "the triangle has no area" + what));
  };
  show(phantom, fmt::format(", and {}", flat.apart));
  show(missed, fmt::format(", and {}", flat.contact));
  if (witnesses.empty()) show(right, "");
  const Degenerate value = same ? *kinds[0].value() : Degenerate::wrong_on_some;
  return decided(value, flat_sentence(value), std::move(witnesses), measured);
}

template ProbeFinding degenerate_triangles(Subject<float>&);
template ProbeFinding degenerate_triangles(Subject<double>&);

}  // namespace axiscert::diagnosis
