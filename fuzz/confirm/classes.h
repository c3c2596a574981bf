// The class of queries within which a kernel is wrong, and elsewhere right: a conjunction of traits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fuzz/queries/capabilities.h"
#include "kernel/names.h"

namespace axiscert::causes {

// Beside a predicate's own traits, the exact answer is one.
inline constexpr TraitSet contact_trait = TraitSet{1} << most_traits,
                          separated_trait = TraitSet{1} << (most_traits + 1);
constexpr TraitSet trait_of(Verdict truth) { return truth == Verdict::contact ? contact_trait : separated_trait; }

// A query whose traits were found, and whether the kernel is wrong on it.
struct Case {
  TraitSet traits;
  bool is_wrong;
};

// How many queries a wrong case and a right one stand for, where more of the one were looked for than of the other.
struct Weights {
  double wrong = 1, right = 1;
};

// The traits that are narrow, and those that stand alone but for the exact answer.
struct TraitKinds {
  TraitSet narrow = 0, alone = 0;
};
TraitKinds kinds_of(const Traits& traits);

struct FoundClass {
  TraitSet traits = 0;  // a query with all of these is in the class; at most three
  // The share of the wrong verdicts that are in the class; of wrong ones among its queries, and among all.
  double share = 0, rate = 0, overall = 0;
};

// So many wrong cases have to be in a class of three traits, of two beside the exact answer, or of a narrow trait:
// fewer are a matter of chance.
inline constexpr double least_of_special = 5;

// The conjunction with the greatest share, among those that explain at least half of the wrong verdicts: the wrong ones
// within it, of these, the right ones within it and the wrong ones outside it; else of all conjunctions. One trait less
// is worth 15 % of it, and among equals the first counts. There is a wrong case.
FoundClass best_class(std::span<const Case> cases, const Weights& weights, const TraitKinds& kinds = {});
// The same of those with a quarter of the wrong verdicts that are wrong on four fifths of their queries: without a
// trait where there is none. A slip that makes an axis part more and less is wrong on all that it decides, and on
// others.
inline constexpr double least_of_sharp = 0.25, sharp_rate = 0.8;
FoundClass sharp_class(std::span<const Case> cases, const Weights& weights, const TraitKinds& kinds = {});

// "spheres in contact nearest to vertex a, with an obtuse corner there".
std::string phrase_of(const Traits& traits, TraitSet found);
// The names, in the order of the phrase.
std::vector<std::string> trait_names(const Traits& traits, TraitSet found);

}  // namespace axiscert::causes
