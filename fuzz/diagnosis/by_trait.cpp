// Clear queries that have a trait: whether the kernel is right on them, for each property that asks about some traits.
#include <algorithm>
#include <string_view>
#include <vector>

#include "fuzz/diagnosis/probes.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json.h"

namespace axiscert::diagnosis {
namespace {

// So many clear queries are looked at, and so many that have a trait are enough; of predicates without filters, whose
// families take longer to make a query, a quarter. Fewer than the least say nothing.
constexpr std::size_t most_looked_at = 6144, enough = 1024, fewest = 20;
constexpr std::uint64_t most_of_family = 512;

template <class Real>
struct TraitQuery {
  Numbers<Real> numbers;
  TraitSet traits;
  Verdict truth;
};

// Clear queries with one of these traits, position by position of every family.
template <class Real>
std::vector<TraitQuery<Real>> clear_having(Subject<Real>& subject, const Traits& traits, TraitSet wanted) {
  const Kernel& kernel = subject.kernel();
  const Oracles& oracles = oracles_of(kernel);
  const std::vector<const Family*> families = families_of(*kernel.predicate, kernel.entry);
  std::vector<TraitQuery<Real>> found;
  const std::size_t part = oracles.has_filters() ? 1 : 4;
  std::size_t looked_at = 0;
  for (std::uint64_t position = 0; position < most_of_family; ++position) {
    for (const Family* family : families) {
      if (looked_at == most_looked_at / part || found.size() == enough / part) return found;
      const Numbers<Real> q = family->make<Real>(subject.seed(), position);
      const std::optional<Verdict> truth = oracles.clear_verdict(q);
      if (!truth || !is_promised(kernel, q)) continue;
      ++looked_at;
      const TraitSet has = traits.of(q, kernel.entry) & wanted;
      if (has != 0) found.push_back({q, has, *truth});
    }
  }
  return found;
}

// By one trait.
struct TraitCounts {
  std::size_t k;
  std::uint64_t wrong = 0, of = 0;
  bool is_more_wrong(const TraitCounts& other) const {
    const std::uint64_t mine = wrong * other.of, its = other.wrong * of;
    return mine != its ? mine > its : wrong > other.wrong;
  }
};

template <class Real>
ProbeFinding by_trait(Subject<Real>& subject, std::string_view property) {
  const Traits* const traits = capabilities_of(subject.predicate()).traits;
  std::vector<TraitCounts> counts;
  TraitSet wanted = 0;
  if (traits != nullptr) {
    for (std::size_t k = 0; k < traits->all.size(); ++k) {
      if (traits->all[k].property != property) continue;
      counts.push_back({k});
      wanted |= one_bit<TraitSet>(k);
    }
  }
  if (wanted == 0) return unasked("No query of this predicate has such a trait.");
  const std::vector<TraitQuery<Real>> clear = clear_having(subject, *traits, wanted);
  if (clear.size() < fewest) {
    return unasked(fmt::format("{} clear {} have such a trait, among those that were looked at: too few to say.",
                               clear.size(), traits->noun));
  }

  Queries<Real> queries;
  for (const TraitQuery<Real>& one : clear) queries.push_back(one.numbers);
  const std::vector<Verdict> said = subject.ask(queries);
  std::uint64_t decided = 0, wrong = 0;
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (!is_decided(said[i])) continue;
    ++decided;
    wrong += said[i] != clear[i].truth;
    for (TraitCounts& of : counts) {
      if (!has_bit(clear[i].traits, of.k)) continue;
      ++of.of;
      of.wrong += said[i] != clear[i].truth;
    }
  }
  Json measured = Json::object();
  for (const TraitCounts& of : counts)
    measured[std::string(traits->all[of.k].name)] = {{"wrong", of.wrong}, {"of", of.of}};
  if (decided < fewest) return undecided("It decides too few of them to say.", std::move(measured));
  if (wrong == 0) {
    const std::string of = decided == said.size() ? "were asked" : fmt::format("it decided, of {} asked", said.size());
    return diagnosis::decided(ByTrait::right,
                              fmt::format("It is right on all {} clear {} that {}.", decided, traits->noun, of), {},
                              std::move(measured));
  }
  const TraitCounts& worst =
      *std::ranges::max_element(counts, [](const TraitCounts& x, const TraitCounts& y) { return y.is_more_wrong(x); });
  std::vector<DiagnosisWitness> witnesses;
  for (std::size_t i = 0; i < said.size() && witnesses.size() < 2; ++i) {
    if (!is_decided(said[i]) || said[i] == clear[i].truth || !has_bit(clear[i].traits, worst.k)) continue;
    witnesses.push_back(
        subject.witness(clear[i].numbers, said[i], "a clear query, which a right method cannot get wrong"));
  }
  return diagnosis::decided(ByTrait::wrong,
                            fmt::format("It is wrong on {} of {} clear {} {}, which no right method gets wrong.",
                                        worst.wrong, worst.of, traits->noun, traits->all[worst.k].phrase),
                            std::move(witnesses), std::move(measured));
}

}  // namespace

template <class Real>
ProbeFinding on_regions(Subject<Real>& subject) {
  return by_trait(subject, "regions");
}
template <class Real>
ProbeFinding on_triangle(Subject<Real>& subject) {
  return by_trait(subject, "on_triangle");
}
template <class Real>
ProbeFinding on_obtuse(Subject<Real>& subject) {
  return by_trait(subject, "obtuse");
}
template <class Real>
ProbeFinding on_parallel(Subject<Real>& subject) {
  return by_trait(subject, "parallel");
}
template <class Real>
ProbeFinding on_flat(Subject<Real>& subject) {
  return by_trait(subject, "flat");
}
template <class Real>
ProbeFinding on_aligned(Subject<Real>& subject) {
  return by_trait(subject, "aligned");
}

#define AXISCERT_INSTANCES(probe)                      \
  template ProbeFinding probe<float>(Subject<float>&); \
  template ProbeFinding probe<double>(Subject<double>&)
AXISCERT_INSTANCES(on_regions);
AXISCERT_INSTANCES(on_triangle);
AXISCERT_INSTANCES(on_obtuse);
AXISCERT_INSTANCES(on_parallel);
AXISCERT_INSTANCES(on_flat);
AXISCERT_INSTANCES(on_aligned);
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
