// Oracles made of a predicate's trait. A predicate's room instantiates this once, in the file that defines
// NAME_oracles().
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <forward_list>
#include <limits>
#include <type_traits>
#include <utility>

#include "exact/judge/clear.h"
#include "exact/judge/oracles.h"
#include "exact/judge/trait.h"
#include "exact/numbers/floating.h"
#include "kernel/base/error.h"
#include "kernel/query.h"

namespace axiscert {

template <class Trait>
struct ExactOfTrait {
  using type = BinaryNumber;
};
template <class Trait>
  requires requires { typename Trait::Exact; }
struct ExactOfTrait<Trait> {
  using type = typename Trait::Exact;
};
template <class Trait>
using ExactOf = typename ExactOfTrait<Trait>::type;

template <PredicateTrait Trait>
class OraclesOf final : public Oracles {
 public:
  const Predicate& predicate() const override { return Trait::description(); }
  std::vector<std::string_view> formulae() const override { return names_of(typename Trait::AllFormulae()); }

  bool is_valid(const Numbers<float>& q) const override { return Trait::is_valid(in_doubles(q)); }
  bool is_valid(const Numbers<double>& q) const override { return Trait::is_valid(in_doubles(q)); }
  std::string why_invalid(const Numbers<float>& q) const override { return reason(q); }
  std::string why_invalid(const Numbers<double>& q) const override { return reason(q); }

  std::unique_ptr<AskedQuery> about(const Numbers<float>& q, Opinion) const override {
    return std::make_unique<EvaluatedQuery<float>>(q);
  }
  std::unique_ptr<AskedQuery> about(const Numbers<double>& q, Opinion) const override {
    return std::make_unique<EvaluatedQuery<double>>(q);
  }
  std::optional<Verdict> clear_verdict(const Numbers<float>& q) const override { return clear_verdict_of(q); }
  std::optional<Verdict> clear_verdict(const Numbers<double>& q) const override { return clear_verdict_of(q); }
  bool has_depth() const override { return HasDepth<Trait>; }
  std::optional<double> depth(const Numbers<float>& q) const override { return depth_of(q); }
  std::optional<double> depth(const Numbers<double>& q) const override { return depth_of(q); }
  std::optional<CriticalLength> critical_length() const override {
    if constexpr (!HasCriticalLength<Trait>) return std::nullopt;
    else if constexpr (requires { Trait::critical_centre; })
      return CriticalLength{first_length(), Trait::squared_critical_length, Trait::critical_centre};
    else return CriticalLength{first_length(), Trait::squared_critical_length};
  }
  bool is_degenerate(const Numbers<float>& q) const override { return says_degenerate(q); }
  bool is_degenerate(const Numbers<double>& q) const override { return says_degenerate(q); }
  std::vector<Detail> details(const Numbers<float>& q) const override { return details_of(q); }
  std::vector<Detail> details(const Numbers<double>& q) const override { return details_of(q); }
  std::vector<std::string_view> detail_names() const override {
    if constexpr (HasDetails<Trait, double>) return Trait::detail_names();
    else return {};
  }
  bool is_within(const Limits& limits, const Numbers<float>& q) const override { return is_inside(limits, q); }
  bool is_within(const Limits& limits, const Numbers<double>& q) const override { return is_inside(limits, q); }
  bool is_promised(const MotionPolicy& policy, const Numbers<float>& q) const override { return promises(policy, q); }
  bool is_promised(const MotionPolicy& policy, const Numbers<double>& q) const override { return promises(policy, q); }
  std::unique_ptr<ContactJudge> contact_judge(const Numbers<float>& q) const override { return contact_judge_of(q); }
  std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>& q) const override { return contact_judge_of(q); }

 private:
  using Exact = ExactOf<Trait>;

  template <class... F>
  static std::vector<std::string_view> names_of(FormulaeList<F...>) {
    return {F::name...};
  }

  template <class T, class Real>
  static auto problem_of(const Numbers<Real>& q) {
    return Trait::template problem<T>([&](std::size_t k) { return T(q[k]); });
  }

  template <class List>
  struct FirstOf;
  template <class F, class... Rest>
  struct FirstOf<FormulaeList<F, Rest...>> {
    using type = F;
  };
  // Those of the theorem.
  using First = typename FirstOf<typename Trait::AllFormulae>::type;

  // Right forms, as far apart as a right kernel may be from them.
  template <class Real>
  static std::optional<Verdict> clear_verdict_of(const Numbers<Real>& q) {
    std::optional<Verdict> found;
    if constexpr (requires { typename Trait::ClearForms; })
      found = clear_verdict_by<Trait>(typename Trait::ClearForms(), q);
    else found = clear_verdict_by<Trait>(FormulaeList<First>(), q);
    if constexpr (requires { Trait::is_clear_at_start(q); }) {
      if (found == Verdict::contact && !Trait::is_clear_at_start(q)) return std::nullopt;
    }
    return found && Trait::is_valid(in_doubles(q)) ? found : std::nullopt;
  }

  // Both sides of each comparison of these formulae: of doubles alone, so that each is compiled once.
  template <class F>
  static ExactSides exact_sides(const Numbers<double>& q) {
    ExactSides sides(Trait::description().comparisons.size());
    const auto keep = [&](std::size_t i, const Exact& lhs, const Exact& rhs) { sides.set(i, lhs, rhs); };
    F::template comparisons<Exact>(problem_of<Exact>(q), keep);
    return sides;
  }
  template <class Real>
  static std::string reason(const Numbers<Real>& q) {
    if constexpr (SaysWhyInvalid<Trait>) return Trait::why_invalid(in_doubles(q));
    else return {};
  }

  // The same of the first formulae, without the sides.
  static ExactSigns exact_signs(const Numbers<double>& q) {
    ExactSigns signs;
    const auto see = [&](std::size_t i, const Exact& lhs, const Exact& rhs) {
      if (lhs == rhs) signs.ties |= one_bit<ComparisonBits>(i);
    };
    signs.holds = bits_of<First, Exact>(problem_of<Exact>(q), see);
    return signs;
  }

  // Formulae made from the first by other relations: the sides are the same.
  template <class F>
  static constexpr bool has_first_sides = std::is_base_of_v<First, F>;

  // A query, and what was evaluated on it.
  template <class Real>
  class EvaluatedQuery final : public AskedQuery, private DepthOf {
   public:
    explicit EvaluatedQuery(const Numbers<Real>& q) : q_(q) {}

    Truth truth() override {
      if (!truth_) truth_ = decided();
      return *truth_;
    }

    void expect(const Kernel& kernel) override {
      const auto expected = [&]<class... F>(FormulaeList<F...>) {
        return ((has_first_sides<F> && F::name == kernel.formulae) || ...);
      };
      keeps_sides_ = keeps_sides_ || expected(typename Trait::AllFormulae());
    }

    std::optional<Reference> chain(const Kernel& kernel) override {
      const EvaluatedFormulae* claim = claim_of(kernel, typename Trait::AllFormulae());
      if (claim == nullptr) return std::nullopt;
      Reference found{outcome(claim->sides.holding(claim->nonstrict)), std::nullopt, claim->sides.ties};
      if (kernel.is_reference) found.rounded = claim->rounded;
      return found;
    }
    const ExactSides* sides(const Kernel& kernel) override {
      const EvaluatedFormulae* claim = claim_of(kernel, typename Trait::AllFormulae());
      return claim == nullptr ? nullptr : &claim->sides;
    }
    DepthOf& depth() override { return *this; }
    std::optional<ExactDepth> exact_depth() override {
      if constexpr (HasDepth<Trait>) {
        if (!depth_) depth_ = Trait::exact_depth(wide_);
      }
      return depth_;
    }

   private:
    struct EvaluatedFormulae {
      std::string_view name;  // of the formulae
      ComparisonBits nonstrict;
      ExactSides sides;
      std::optional<RoundedDecisions> rounded;  // of a kernel that claims the reference's bits
    };

    Truth decided() {
      const PredicateEntry& entry = Trait::description().entries[entry_of<Trait>()];
      if (q_.size() != entry.columns.size()) {
        throw HarnessFault(fmt::format("{}: the oracles of entry {}, of {} columns, are asked about {} numbers",
                                       Trait::description().id, entry.name, entry.columns.size(), q_.size()));
      }
      if (!Trait::is_valid(wide_)) return {Verdict::invalid, false};
      const auto truth = Trait::geometric_truth(wide_);
      const std::string wrong = Trait::contradiction(wide_, truth, signs().holds, signs().ties);
      if (!wrong.empty()) {
        throw OracleDisagreement(fmt::format("{}: {}", Trait::description().id, wrong), q_, Trait::description(),
                                 entry_of<Trait>());
      }
      return truth;
    }

    double at_least() override { return exactly(); }
    double at_most() override { return exactly(); }
    bool is_touching() override { return truth().touching; }
    double exactly() override {
      if (!rounded_) rounded_ = is_touching() || !exact_depth() ? 0 : rounded_depth(*exact_depth());
      return *rounded_;
    }
    double length() override { return is_touching() || !exact_depth() ? 0 : rounded_length(*exact_depth()); }
    double length_at_most() override { return length(); }

    // Null for a kernel that claims nothing.
    template <class... F>
    const EvaluatedFormulae* claim_of(const Kernel& kernel, FormulaeList<F...>) {
      if (kernel.formulae.empty()) return nullptr;
      EvaluatedFormulae* found = nullptr;
      const auto evaluate = [&]<class One>() {
        if (found != nullptr || One::name != kernel.formulae) return;
        found = &evaluated<One>();
        if (kernel.is_reference && !found->rounded) found->rounded = rounded<One>();
      };
      (evaluate.template operator()<F>(), ...);
      if (found != nullptr) return found;
      throw HarnessFault(fmt::format("kernel '{}' claims formulae '{}', which {} has not", kernel.id, kernel.formulae,
                                     kernel.predicate->id));
    }

    template <class F>
    EvaluatedFormulae& evaluated() {
      for (EvaluatedFormulae& known : evaluated_) {
        if (known.name == F::name) return known;
      }
      EvaluatedFormulae& found =
          evaluated_.emplace_front(EvaluatedFormulae{F::name, nonstrict_comparisons<F>(), sides_of<F>(), std::nullopt});
      if (F::kind == FormulaeKind::rung) require_same_signs(F::name, found.sides);
      return found;
    }
    // R, and R-infinity: where the range was left by MPFR, whose exponents have no end that a query could reach.
    template <class F>
    RoundedDecisions rounded() const {
      constexpr auto ignore = [](std::size_t, const auto&, const auto&) {};
      const BitsInRange reference = bits_in_range([&] { return bits_of<F, Real>(problem_of<Real>(q_), ignore); });
      const Outcome found = outcome(reference.bits);
      if (reference.stayed) return {found, found};
      const FloatingScope scope({std::numeric_limits<Real>::digits, Rounding::nearest, {}});
      return {outcome(bits_of<F, Floating>(problem_of<Floating>(wide_), ignore)), found};
    }
    static Outcome outcome(ComparisonBits bits) { return {verdict_of(Trait::description(), bits), bits}; }

    // The signs of the first formulae.
    const ExactSigns& signs() {
      if (signs_) return *signs_;
      if (keeps_sides_) {
        first_ = exact_sides<First>(wide_);
        signs_ = ExactSigns{first_->holding(nonstrict_comparisons<First>()), first_->ties};
      } else {
        signs_ = exact_signs(wide_);
      }
      return *signs_;
    }
    // Those that the signs were found from are handed on to the first claim that has them.
    template <class F>
    ExactSides sides_of() {
      if (!has_first_sides<F> || !first_) return exact_sides<F>(wide_);
      return *std::exchange(first_, std::nullopt);
    }

    void require_same_signs(std::string_view name, const ExactSides& rung) {
      const ComparisonBits strict = signs().holds & ~signs().ties;
      if (rung.strict == strict && rung.ties == signs().ties) return;
      throw OracleDisagreement(
          fmt::format(
              "{}: formulae {} have the exact signs {:#b} ties {:#b}, the first formulae {:#b} ties {:#b} (bit 0 "
              "is the first comparison)",
              Trait::description().id, name, rung.strict, rung.ties, strict, signs().ties),
          q_, Trait::description(), entry_of<Trait>());
    }

    const Numbers<Real> q_;
    const Numbers<double> wide_ = in_doubles(q_);
    std::optional<Truth> truth_;
    std::optional<ExactDepth> depth_;
    std::optional<double> rounded_;
    std::optional<ExactSigns> signs_;
    bool keeps_sides_ = false;
    std::optional<ExactSides> first_;  // of the first formulae
    std::forward_list<EvaluatedFormulae> evaluated_;
  };

  template <class Real>
  static std::optional<double> depth_of(const Numbers<Real>& q) {
    if constexpr (HasDepth<Trait>) return rounded_depth(Trait::exact_depth(in_doubles(q)));
    else return std::nullopt;
  }
  static std::size_t first_length() {
    const std::vector<PredicateColumn>& columns = Trait::description().entries[entry_of<Trait>()].columns;
    const auto is_length = [](const PredicateColumn& column) { return column.role == Role::length; };
    return static_cast<std::size_t>(std::find_if(columns.begin(), columns.end(), is_length) - columns.begin());
  }
  template <class Real>
  static bool says_degenerate(const Numbers<Real>& q) {
    if constexpr (SaysDegenerate<Trait, Real>) return Trait::template is_degenerate<Real>(in_doubles(q));
    else return false;
  }
  template <class Real>
  static std::vector<Detail> details_of(const Numbers<Real>& q) {
    if constexpr (HasDetails<Trait, Real>) return Trait::template details<Real>(in_doubles(q));
    else return {};
  }
  // Numbers that are no query have neither a front nor a distance.
  template <class Real>
  static bool is_inside(const Limits& limits, const Numbers<Real>& q) {
    const Numbers<double> wide = in_doubles(q);
    if (!Trait::is_valid(wide)) return true;
    if constexpr (HasFront<Trait>) {
      if (limits.sides == SidesPolicy::front && !Trait::is_in_front(wide)) return false;
    }
    if constexpr (HasDistance<Trait>) {
      if (limits.margin != 0 && is_within_margin(Trait::distance(wide), limits.margin)) return false;
    }
    return true;
  }
  template <class Real>
  static bool promises(const MotionPolicy& policy, const Numbers<Real>& q) {
    if constexpr (HasMotionPolicy<Trait>) return policy == MotionPolicy{} || Trait::is_promised(policy, in_doubles(q));
    else return true;
  }
  template <class Real>
  static std::unique_ptr<ContactJudge> contact_judge_of(const Numbers<Real>& q) {
    if constexpr (HasContactJudge<Trait, Real>) return Trait::template contact_judge<Real>(in_doubles(q));
    else return nullptr;
  }
};

}  // namespace axiscert
