// The answer of a kernel at touching.
#include <cctype>

#include "fuzz/diagnosis/probes/probes.h"
#include "fuzz/diagnosis/probes/tallied.h"
#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/diagnosis/scenes/scenes_by_trait.h"
#include "kernel/base/error.h"

namespace axiscert::diagnosis {
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
    return undecided(fmt::format("It answers {} of {} {} that touch, and is right on the same {} with half the {} and "
                                 "half as much again: too few to say.",
                                 counted, touching.size(), scenes.what, scenes.what, scenes.length),
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

}  // namespace axiscert::diagnosis
