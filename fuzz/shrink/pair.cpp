#include "fuzz/shrink/pair.h"

#include <fmt/format.h>

#include <algorithm>

#include "fuzz/queries/source.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/base/error.h"

namespace axiscert {

// Asks one kernel about a query and its image. In no unnamed namespace, because a lambda of shrink_pair, which other
// sources call, holds it.
template <class Real>
class PairSymptomFinder {
 public:
  PairSymptomFinder(const Kernel& kernel, std::string_view target) : kernel_(kernel), target_(target) {}

  // Empty if the answers do not differ, or one is missing or declined.
  std::optional<PairSymptom> symptom(const Numbers<Real>& q, const Numbers<Real>& image_of_it,
                                     const ImageMap<Real>& map) {
    for (const Numbers<Real>* each : {&q, &image_of_it}) {
      if (!oracles_of(kernel_).is_valid(*each) || !is_promised(kernel_, *each)) return std::nullopt;
    }
    const Outcome of_query = answer(q), of_image = answer(image_of_it);
    if (of_query.verdict == Verdict::unanswered || of_image.verdict == Verdict::unanswered) return std::nullopt;
    if (of_query.verdict == Verdict::undecided || of_image.verdict == Verdict::undecided) return std::nullopt;
    PairSymptom found{of_query.verdict, of_image.verdict, std::nullopt, kernel_.predicate};
    if (of_query.verdict != of_image.verdict) return found;
    if (!of_query.bits || !of_image.bits) return std::nullopt;
    const ComparisonBits differing = map.of_query(*of_image.bits) ^ *of_query.bits;
    if (differing == 0) return std::nullopt;
    found.which = first_bit(differing);
    return found;
  }

 private:
  Outcome answer(const Numbers<Real>& q) {
    if (!implementation_) implementation_ = kernel_.on<Real>(target_);
    const Reply<Real> reply = ask(*implementation_, q);
    if (reply.verdicts[0] == Verdict::unanswered) implementation_.reset();
    return reply.outcome(0);
  }

  const Kernel& kernel_;
  std::string_view target_;
  std::optional<Implementation<Real>> implementation_;
};

namespace {

bool is_same(const PairSymptom& x, const PairSymptom& y) {
  return x.of_query == y.of_query && x.of_image == y.of_image && x.which == y.which;
}

template <class Real>
Severity severity_of(const Kernel& kernel, const Numbers<Real>& q, const PairSymptom& symptom) {
  if (symptom.which) return {Rational(0), "no depth: the verdicts are the same"};
  return depth_severity(*oracles_of(kernel).about(q, Opinion::first));
}

// A query file may state anything as its address.
std::optional<Address> address_in(const std::string& given) {
  try {
    return parse_address(given);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::string text(const PairSymptom& symptom) {
  if (!symptom.which) return fmt::format("{}, and {} of its image", name(symptom.of_query), name(symptom.of_image));
  return fmt::format("{} of both, but {} differs", name(symptom.of_query),
                     symptom.predicate->comparisons[*symptom.which].name);
}

namespace {

// A query of a family of images, by its address, and where its group of a base and its images begins.
struct GroupPlace {
  const ImageGroup* group;
  SourcePtr source;
  Address address;
  std::uint64_t position, base;

  template <class Real>
  Numbers<Real> make(std::uint64_t at) const {
    return source->template make<Real>(address.seed, at);
  }
  std::string address_of(std::uint64_t at) const {
    return SeededSource{*source, address.seed, address.precision}.address(at);
  }
};

template <class Real>
std::optional<GroupPlace> place_in_group(const std::string& given, const Kernel& kernel) {
  const std::optional<Address> address = address_in(given);
  if (!address) return std::nullopt;
  const ImageGroup* group = image_group(address->name);
  if (group == nullptr || address->precision != precision_of<Real>) return std::nullopt;
  SourcePtr source = family_source(find_family(address->name));
  if (source->version() != address->version || source->predicate().id != kernel.predicate->id ||
      source->entry() != kernel.entry)
    return std::nullopt;
  const std::uint64_t position = address->position();
  return GroupPlace{group, std::move(source), *address, position, position - position % group->size};
}

}  // namespace

template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const std::string& given, const Kernel& kernel, std::string_view target) {
  const auto place = place_in_group<Real>(given, kernel);
  const ImageMaps* const maps = place ? capabilities_of(place->group->predicate()).image_maps : nullptr;
  if (maps == nullptr) return std::nullopt;
  const Oracles& oracles = oracles_of(kernel);
  const std::uint64_t position = place->position, base = place->base, size = place->group->size;
  const Numbers<Real> q = place->template make<Real>(position);
  PairSymptomFinder<Real> finder(kernel, target);
  for (std::uint64_t other = base; other < base + size; ++other) {
    if (other == position) continue;
    if (position != base && other != base) break;
    const Numbers<Real> image_of_it = place->template make<Real>(other);
    if (!oracles.is_valid(q) || !oracles.is_valid(image_of_it)) continue;
    std::unique_ptr<ImageMap<Real>> map = maps->between(q, image_of_it);
    if (!map) continue;
    if (const auto symptom = finder.symptom(q, image_of_it, *map))
      return Pair<Real>{q, image_of_it, std::move(map), *symptom};
  }
  return std::nullopt;
}
template std::optional<Pair<float>> asymmetric_pair(const std::string&, const Kernel&, std::string_view);
template std::optional<Pair<double>> asymmetric_pair(const std::string&, const Kernel&, std::string_view);

template <class Real>
std::optional<Pair<Real>> asymmetric_pair(const Numbers<Real>& q, const std::string& stated, const Kernel& kernel,
                                          std::string_view target) {
  auto pair = asymmetric_pair<Real>(stated, kernel, target);
  if (pair && !std::equal(q.begin(), q.end(), pair->query.begin(), pair->query.end())) return std::nullopt;
  return pair;
}
template std::optional<Pair<float>> asymmetric_pair(const Numbers<float>&, const std::string&, const Kernel&,
                                                    std::string_view);
template std::optional<Pair<double>> asymmetric_pair(const Numbers<double>&, const std::string&, const Kernel&,
                                                     std::string_view);

template <class Real>
std::optional<WrongRelative<Real>> wrong_relative(const Numbers<Real>& q, const std::string& stated,
                                                  const Kernel& kernel, std::string_view target) {
  const auto place = place_in_group<Real>(stated, kernel);
  if (!place) return std::nullopt;
  const Numbers<Real> own = place->template make<Real>(place->position);
  if (!std::equal(q.begin(), q.end(), own.begin(), own.end())) return std::nullopt;
  SymptomFinder<Real> finder(kernel, target);
  for (std::uint64_t other = place->base; other < place->base + place->group->size; ++other) {
    if (other == place->position) continue;
    const Numbers<Real> relative = place->template make<Real>(other);
    if (!oracles_of(kernel).is_valid(relative) || !is_promised(kernel, relative)) continue;
    const std::vector<Symptom> flips = finder.flips(relative);
    if (!flips.empty() && flips.front().level == Level::verdict)
      return WrongRelative<Real>{place->address_of(other), relative};
  }
  return std::nullopt;
}
template std::optional<WrongRelative<float>> wrong_relative(const Numbers<float>&, const std::string&, const Kernel&,
                                                            std::string_view);
template std::optional<WrongRelative<double>> wrong_relative(const Numbers<double>&, const std::string&, const Kernel&,
                                                             std::string_view);

template <class Real>
ShrunkPair<Real> shrink_pair(const Pair<Real>& pair, const Kernel& kernel, std::string_view target, std::uint64_t limit,
                             KeepingRule keeping, const CountEvaluations& evaluated) {
  PairSymptomFinder<Real> finder(kernel, target);
  const auto severity = [&](const Numbers<Real>& q) -> std::optional<Severity> {
    const auto image_of_it = pair.map->image(q);
    if (!image_of_it) return std::nullopt;
    const auto symptom = finder.symptom(q, *image_of_it, *pair.map);
    if (!symptom || !is_same(*symptom, pair.symptom)) return std::nullopt;
    return severity_of(kernel, q, *symptom);
  };
  if (!severity(pair.query)) {
    throw Error(
        fmt::format("{} does not answer the query and its image differently: {}", kernel.id, text(pair.symptom)));
  }
  ShrinkResult<Real> found =
      shrink<Real>(*kernel.predicate, pair.query, SeverityOn<Real>(severity), keeping, limit, evaluated, kernel.entry);
  const Numbers<Real> image_of_it = *pair.map->image(found.query);
  return {std::move(found), image_of_it};
}
template ShrunkPair<float> shrink_pair(const Pair<float>&, const Kernel&, std::string_view, std::uint64_t, KeepingRule,
                                       const CountEvaluations&);
template ShrunkPair<double> shrink_pair(const Pair<double>&, const Kernel&, std::string_view, std::uint64_t,
                                        KeepingRule, const CountEvaluations&);

}  // namespace axiscert
