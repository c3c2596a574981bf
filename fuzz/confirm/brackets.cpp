#include "fuzz/confirm/brackets.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "exact/judge/critical_radius.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {
namespace {

// Halves of an ulp of the scene that a right form may be off by: it has some twenty roundings in a row, each of at most
// three times the scene. The built-in forms that are right over the reals stay below two thirds of it.
constexpr double most_roundings = 64;

// A right form's own error as a length. Where it takes the difference of squares, the error of a square is that of the
// scene's, and of the root so much more as the length is smaller than the scene.
template <class Real>
double rounding_of(const SlackScene& scene) {
  constexpr double u = std::numeric_limits<Real>::epsilon() / 2;
  return most_roundings * u * scene.scene * std::max(1.0, scene.scene / scene.apart);
}

template <class Real>
bool turns_at_one(const Oracles& oracles, const SlackScene& scene) {
  const double off = rounding_of<Real>(scene) / scene.unit;
  if (!(off < 0.25)) return false;
  const auto says = [&](double x, Verdict verdict) {
    return oracles.about(query_at(scene, static_cast<Real>(x)), Opinion::first)->truth().verdict == verdict;
  };
  const Verdict below = scene.turns_to_separated ? Verdict::contact : Verdict::separated;
  const Verdict above = scene.turns_to_separated ? Verdict::separated : Verdict::contact;
  return says(1 - off, below) && says(1 + off, above);
}

// The scene just where the two have a point in common: what a kernel declares of margins leaves that in.
template <class Real>
Numbers<Real> in_contact(const SlackScene& scene) {
  const double off = rounding_of<Real>(scene) / scene.unit;
  return query_at(scene, static_cast<Real>(scene.turns_to_separated ? 1 - off : 1 + off));
}

// The scenes of an entry whose exact turn is where it was put, by both sides of it. They depend on no kernel, and those
// of the last ones are kept.
template <class Real>
std::shared_ptr<const std::vector<SlackScene>> turning_scenes(const Predicate& predicate, std::size_t entry,
                                                              std::uint64_t seed) {
  using Key = std::tuple<const Predicate*, std::size_t, std::uint64_t>;
  static std::mutex mutex;
  static std::map<Key, std::shared_ptr<const std::vector<SlackScene>>> kept;
  constexpr std::size_t most_kept = 8;
  const std::lock_guard lock(mutex);
  const Key key{&predicate, entry, seed};
  if (const auto found = kept.find(key); found != kept.end()) return found->second;
  std::vector<SlackScene> scenes;
  if (const SlackScenes* made = capabilities_of(predicate).slack_scenes)
    scenes = made->make(entry, precision_of<Real>, seed);
  const Oracles& oracles = oracles_of(predicate, entry);
  std::erase_if(scenes, [&](const SlackScene& scene) { return !turns_at_one<Real>(oracles, scene); });
  if (kept.size() == most_kept) kept.clear();
  return kept[key] = std::make_shared<const std::vector<SlackScene>>(std::move(scenes));
}

Verdict exchanged(Verdict said) {
  if (said == Verdict::contact) return Verdict::separated;
  return said == Verdict::separated ? Verdict::contact : said;
}

// The kernel as one that is asked with a scene's number and x: what bisects over a length does so over paths then.
template <class Real>
Implementation<Real> on_paths(const Implementation<Real>& kernel, const std::vector<SlackScene>& scenes,
                              std::uint64_t& answers) {
  Implementation<Real> on;
  on.verdicts = [&](const QueryColumns<Real>& batch, Verdict* out) {
    QueryBatch<Real> queries(batch.size, scenes.front().base.size());
    const auto scene = [&](std::size_t i) -> const SlackScene& {
      return scenes[static_cast<std::size_t>(batch.column[0][i])];
    };
    for (std::size_t i = 0; i < batch.size; ++i) queries.push_back(query_at(scene(i), batch.column[1][i]));
    std::fill_n(out, batch.size, Verdict::unanswered);
    kernel.verdicts(queries.columns(), out);
    answers += batch.size;
    for (std::size_t i = 0; i < batch.size; ++i) {
      if (scene(i).turns_to_separated) out[i] = exchanged(out[i]);
    }
  };
  return on;
}

// The margin that a kernel declares, as a length by which its contacts may come early: no slack.
double declared_margin(const Kernel& kernel) { return kernel.limits.margin; }

}  // namespace

template <class Real>
Numbers<Real> query_at(const SlackScene& scene, Real x) {
  Numbers<Real> query(scene.base.size());
  for (std::size_t k = 0; k < query.size(); ++k) {
    const auto base = static_cast<Real>(scene.base[k]);
    query[k] = scene.step[k] == 0 ? base : base + x * static_cast<Real>(scene.step[k]);
  }
  return query;
}

template <class Real>
Brackets brackets_of(const Kernel& kernel, std::uint64_t seed, const std::string& target) {
  Brackets found;
  for (const SlackScene& scene : *turning_scenes<Real>(*kernel.predicate, kernel.entry, seed)) {
    if (is_promised(kernel, in_contact<Real>(scene))) found.scenes.push_back(scene);
  }
  if (found.scenes.empty()) return found;
  const Implementation<Real> implementation = kernel.on<Real>(target);
  const Implementation<Real> on = on_paths(implementation, found.scenes, found.answers);
  std::map<double, std::vector<std::size_t>> by_greatest;  // those that are asked up to the same x
  for (std::size_t i = 0; i < found.scenes.size(); ++i) by_greatest[found.scenes[i].greatest].push_back(i);
  for (const auto& [greatest, which] : by_greatest) {
    std::vector<QueryWithRadius<Real>> paths;
    for (const std::size_t i : which) paths.push_back({{static_cast<Real>(i), Real(1)}, 1});
    constexpr Real least(0.25);
    const auto turns = critical_radii(on, paths, {least, static_cast<Real>(greatest)});
    for (std::size_t i = 0; i < which.size(); ++i) {
      const SlackScene& scene = found.scenes[which[i]];
      // One that answers the same from end to end of the path has no turn.
      if (!turns[i].answered || turns[i].not_decided || !turns[i].radius || *turns[i].radius == least) continue;
      const auto turn = static_cast<double>(*turns[i].radius);
      double early = (scene.turns_to_separated ? turn - 1 : 1 - turn) * scene.unit;
      if (early > 0) early = std::max(0.0, early - declared_margin(kernel));
      found.all.push_back({&scene, early, rounding_of<Real>(scene), turn});
    }
  }
  return found;
}

#define AXISCERT_INSTANCES(Real)                            \
  template Numbers<Real> query_at(const SlackScene&, Real); \
  template Brackets brackets_of<Real>(const Kernel&, std::uint64_t, const std::string&);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert
