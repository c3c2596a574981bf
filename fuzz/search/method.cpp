#include "fuzz/search/method.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/search/moves.h"

namespace axiscert {
namespace {

// Lengths are looked for up to here: no settled query has a distance of as much.
constexpr double greatest_length = 0x1p10;

}  // namespace

template <class Real>
VerdictGuide<Real>::VerdictGuide(const Kernel& kernel, std::string_view target)
    : Guide<Real>(shape_of(kernel.predicate->entries[kernel.entry])),
      kernel_(kernel),
      oracles_(oracles_of(kernel)),
      implementation_(kernel.on<Real>(target)) {
  const QueryShape& shape = this->shape();
  for (std::size_t k = 0; k < shape.numbers && !length_; ++k) {
    if (shape.is_length[k]) length_ = k;
  }
}

template <class Real>
void VerdictGuide<Real>::settle(Numbers<Real>& q) const {
  axiscert::settle(this->shape(), q);
}

// All queries at once: the kernel is asked about a batch for each bit of a float. A query whose verdict does not change
// between no length and the greatest keeps that at which it may be wrong.
template <class Real>
void VerdictGuide<Real>::solve_lengths(Goal goal, QueryBatch<Real>& batch) {
  // Not negative floats as integers in the same order.
  using Order = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  struct Bracket {
    Order apart, touching;  // the kernel says "separated" and "contact" there
    Real middle() const { return std::bit_cast<Real>(static_cast<Order>(apart + (touching - apart) / 2)); }
  };
  const auto lengths = batch.mutable_columns().column[*length_];
  const Order most = std::bit_cast<Order>(static_cast<Real>(greatest_length));
  std::vector<Bracket> brackets(batch.size(), Bracket{0, most});
  Reply<Real> reply;
  const auto asked = [&](auto&& length) -> const std::vector<Verdict>& {
    for (std::size_t i = 0; i < batch.size(); ++i) lengths[i] = length(i);
    ask(implementation_, batch.columns(), reply);
    return reply.verdicts;
  };
  const auto narrow = [&](std::size_t i, Order at, Verdict verdict) {
    (verdict == Verdict::contact ? brackets[i].touching : brackets[i].apart) = at;
  };
  const std::vector<Verdict> without = asked([](std::size_t) { return Real(0); });
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (without[i] == Verdict::contact) brackets[i].touching = 0;
  }
  for (int bit = 0; bit < static_cast<int>(8 * sizeof(Real)); ++bit) {
    const auto& verdicts = asked([&](std::size_t i) { return brackets[i].middle(); });
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (brackets[i].touching - brackets[i].apart > 1) narrow(i, std::bit_cast<Order>(lengths[i]), verdicts[i]);
    }
  }
  for (std::size_t i = 0; i < batch.size(); ++i)
    lengths[i] = std::bit_cast<Real>(goal == Goal::missed_contact ? brackets[i].apart : brackets[i].touching);
}

template <class Real>
double VerdictGuide<Real>::score(Goal goal, const Numbers<Real>& q, Verdict said) const {
  if (said != (goal == Goal::missed_contact ? Verdict::separated : Verdict::contact)) return 0;
  if constexpr (std::is_same_v<Real, float>) {
    const Quantities* const quantities = capabilities_of(*kernel_.predicate).quantities;
    if (quantities != nullptr && quantities->rough_depth != nullptr) {
      const double rough = quantities->rough_depth(kernel_.entry, in_doubles(q));
      // A depth that is no number is 0.
      return std::max(0.0, goal == Goal::missed_contact ? rough : -rough);
    }
  }
  const Truth truth = oracles_.truth(q);
  const auto right = truth.verdict == Verdict::invalid ? std::nullopt : right_verdict(truth, kernel_.touching);
  return right && *right != said ? oracles_.depth(q).value_or(0) : 0;
}

template <class Real>
void VerdictGuide<Real>::evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                                  std::vector<Verdict>& said) {
  if (length_) solve_lengths(aim.goal, batch);
  Reply<Real> reply;
  ask(implementation_, batch.columns(), reply);
  scores.assign(batch.size(), 0);
  for (std::size_t i = 0; i < batch.size(); ++i) scores[i] = score(aim.goal, batch[i], reply.verdicts[i]);
  said = reply.verdicts;
}

template class VerdictGuide<float>;
template class VerdictGuide<double>;

namespace {

class SearchByVerdicts final : public SearchMethod {
 public:
  std::vector<Aim> aims(const Kernel& kernel, const std::vector<std::size_t>& /*only*/) const override {
    if (!oracles_of(kernel).has_depth()) return {};
    return {{Goal::missed_contact}, {Goal::phantom_contact}};
  }
  std::string why_no_aims(const Kernel& kernel) const override {
    return fmt::format("the predicate {} has no depth, by which wrong verdicts are compared", kernel.predicate->id);
  }
  IslandShare share(const Aim&) const override { return {1, 1 << 10}; }
  std::unique_ptr<Guide<float>> guide(const Kernel& kernel, std::string_view target,
                                      std::type_identity<float>) const override {
    return std::make_unique<VerdictGuide<float>>(kernel, target);
  }
  std::unique_ptr<Guide<double>> guide(const Kernel& kernel, std::string_view target,
                                       std::type_identity<double>) const override {
    return std::make_unique<VerdictGuide<double>>(kernel, target);
  }
  const SearchDefaults& defaults() const override {
    static const SearchDefaults defaults = {.evaluations = 1 << 14, .first_queries = 1 << 9};
    return defaults;
  }
  std::vector<std::string> notes() const override {
    return {
        "A depth is in units of the scene. Queries are of numbers up to 2^8; a length is set to where the kernel's own "
        "verdict changes. Every witness was confirmed by all oracles of the predicate. These are lower bounds of the "
        "worst: "
        "a search proves nothing about what it does not find."};
  }
};

}  // namespace

const SearchMethod& search_method_of(const Predicate& predicate) {
  static const SearchByVerdicts by_verdicts;
  const SearchMethod* own = capabilities_of(predicate).search_method;
  return own ? *own : by_verdicts;
}

}  // namespace axiscert
