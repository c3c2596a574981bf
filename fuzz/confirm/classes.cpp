#include "fuzz/confirm/classes.h"

#include <bit>

#include "kernel/base/enums.h"

namespace axiscert::causes {
namespace {

// One bit a case.
using Cases = std::vector<std::uint64_t>;

Cases both(const Cases& x, const Cases& y) {
  Cases of(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) of[i] = x[i] & y[i];
  return of;
}
double cases_in(const Cases& cases) {
  int sum = 0;
  for (const std::uint64_t word : cases) sum += std::popcount(word);
  return sum;
}

// The cases that have a trait, wrong ones and right ones.
struct Split {
  Cases wrong, right;
  friend Split operator&(const Split& x, const Split& y) { return {both(x.wrong, y.wrong), both(x.right, y.right)}; }
};

class Search {
 public:
  Search(std::span<const Case> cases, const Weights& weights, const TraitKinds& kinds, bool is_sharp)
      : weights_(weights), kinds_(kinds), is_sharp_(is_sharp) {
    std::size_t wrong = 0, right = 0;
    for (const Case& one : cases) ++(one.is_wrong ? wrong : right);
    wrong_ = weights.wrong * static_cast<double>(wrong);
    right_ = weights.right * static_cast<double>(right);
    const Split none{Cases(wrong / 64 + 1), Cases(right / 64 + 1)};
    std::vector<Split> of(64, none);
    wrong = right = 0;
    for (const Case& one : cases) {
      const std::size_t place = one.is_wrong ? wrong++ : right++;
      for_each_bit(one.traits, [&](std::size_t k) {
        Cases& to = one.is_wrong ? of[k].wrong : of[k].right;
        to[place / 64] |= std::uint64_t{1} << place % 64;
      });
    }
    // The exact answer first, of which a sentence without it says less; then the traits in their order.
    for (const std::size_t k : order()) {
      if (cases_in(of[k].wrong) == 0) continue;  // no class of wrong verdicts has it
      trait_.push_back(k);
      having_.push_back(std::move(of[k]));
    }
  }

  FoundClass best() {
    for (std::size_t i = 0; i < having_.size(); ++i) {
      see(bit(i), having_[i], 1);
      for (std::size_t j = i + 1; j < having_.size(); ++j) {
        const Split two = having_[i] & having_[j];
        see(bit(i) | bit(j), two, 2);
        for (std::size_t k = j + 1; k < having_.size(); ++k) see(bit(i) | bit(j) | bit(k), two & having_[k], 3);
      }
    }
    return best_;
  }

 private:
  static std::vector<std::size_t> order() {
    std::vector<std::size_t> all = {most_traits, most_traits + 1};
    for (std::size_t k = 0; k < most_traits; ++k) all.push_back(k);
    return all;
  }
  TraitSet bit(std::size_t i) const { return one_bit<TraitSet>(trait_[i]); }

  void see(TraitSet traits, const Split& cases, int size) {
    const double wrong_cases = cases_in(cases.wrong);
    const int own = size - ((traits & (contact_trait | separated_trait)) != 0 ? 1 : 0);
    const bool is_special = own >= 2 || (traits & kinds_.narrow) != 0;
    if (wrong_cases == 0 || (is_special && wrong_cases < least_of_special)) return;
    const double wrong = weights_.wrong * wrong_cases, right = weights_.right * cases_in(cases.right);
    if ((traits & kinds_.alone) != 0 && (own >= 2 || wrong < right)) return;
    if (is_sharp_ &&
        (wrong_cases < least_of_special || wrong < least_of_sharp * wrong_ || wrong < sharp_rate * (wrong + right)))
      return;
    const double explains_most = 2 * wrong >= wrong_ ? 1 : 0;
    constexpr double worth[] = {1, 0.85, 0.85 * 0.85};  // by the number of traits
    const double score = explains_most + worth[size - 1] * (wrong / (wrong_ + right));
    if (score <= best_score_) return;
    best_score_ = score;
    best_ = {traits, wrong / wrong_, wrong / (wrong + right), wrong_ / (wrong_ + right_)};
  }

  Weights weights_;
  TraitKinds kinds_;
  bool is_sharp_;
  double wrong_ = 0, right_ = 0, best_score_ = -1;
  std::vector<std::size_t> trait_;
  std::vector<Split> having_;
  FoundClass best_;
};

}  // namespace

FoundClass best_class(std::span<const Case> cases, const Weights& weights, const TraitKinds& kinds) {
  return Search(cases, weights, kinds, false).best();
}
FoundClass sharp_class(std::span<const Case> cases, const Weights& weights, const TraitKinds& kinds) {
  return Search(cases, weights, kinds, true).best();
}

TraitKinds kinds_of(const Traits& traits) {
  TraitKinds kinds;
  for (std::size_t k = 0; k < traits.all.size(); ++k) {
    kinds.narrow |= bit_if<TraitSet>(traits.all[k].is_narrow, k);
    kinds.alone |= bit_if<TraitSet>(traits.all[k].stands_alone, k);
  }
  return kinds;
}

std::string phrase_of(const Traits& traits, TraitSet found) {
  std::string text((found & separated_trait) != 0 ? "separated " : "");
  text += traits.noun;
  if ((found & contact_trait) != 0) text += " in contact";
  bool is_first = true;
  for_each_bit(found & ~(contact_trait | separated_trait), [&](std::size_t k) {
    text += is_first ? " " : ", ";
    text += traits.all[k].phrase;
    is_first = false;
  });
  return text;
}

std::vector<std::string> trait_names(const Traits& traits, TraitSet found) {
  std::vector<std::string> names;
  if ((found & contact_trait) != 0) names.emplace_back("contact");
  if ((found & separated_trait) != 0) names.emplace_back("separated");
  for_each_bit(found & ~(contact_trait | separated_trait),
               [&](std::size_t k) { names.emplace_back(traits.all[k].name); });
  return names;
}

}  // namespace axiscert::causes
