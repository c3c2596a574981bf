// Oracles made of a test's trait. A test's room instantiates this once, in the file that defines NAME_oracles().
#pragma once

#include <fmt/format.h>

#include <limits>

#include "exact/numbers/floating.h"
#include "exact/trait/dyadic_number.h"
#include "exact/trait/oracles.h"
#include "exact/trait/trait.h"
#include "kernel/base/error.h"

namespace axiscert {

template <class Test>
struct ExactOfTrait {
  using type = DyadicNumber;
};
template <class Test>
  requires requires { typename Test::Exact; }
struct ExactOfTrait<Test> {
  using type = typename Test::Exact;
};
template <class Test>
using ExactOf = typename ExactOfTrait<Test>::type;

template <TestTrait Test>
class OraclesOf final : public Oracles {
 public:
  const TestDescription& test() const override { return Test::description(); }
  std::vector<std::string_view> formulae() const override { return names_of(typename Test::AllFormulae()); }

  std::string why_invalid(const Numbers<float>& q) const override { return reason(q); }
  std::string why_invalid(const Numbers<double>& q) const override { return reason(q); }

  Truth truth(const Numbers<float>& q) const override { return truth_of(q); }
  Truth truth(const Numbers<double>& q) const override { return truth_of(q); }
  std::optional<Claimed> claimed(const Kernel& kernel, const Numbers<float>& q) const override {
    return claimed_by(kernel, q, typename Test::AllFormulae());
  }
  std::optional<Claimed> claimed(const Kernel& kernel, const Numbers<double>& q) const override {
    return claimed_by(kernel, q, typename Test::AllFormulae());
  }
  bool has_depth() const override { return HasDepth<Test>; }
  std::optional<double> depth(const Numbers<float>& q) const override { return depth_of(q); }
  std::optional<double> depth(const Numbers<double>& q) const override { return depth_of(q); }
  std::vector<Detail> details(const Numbers<float>& q) const override { return details_of(q); }
  std::vector<Detail> details(const Numbers<double>& q) const override { return details_of(q); }
  bool is_promised(const MotionPolicy& policy, const Numbers<float>& q) const override { return promises(policy, q); }
  bool is_promised(const MotionPolicy& policy, const Numbers<double>& q) const override { return promises(policy, q); }
  std::unique_ptr<MotionJudge> motion_judge(const Numbers<float>& q) const override { return motion_judge_of(q); }
  std::unique_ptr<MotionJudge> motion_judge(const Numbers<double>& q) const override { return motion_judge_of(q); }

 private:
  using Exact = ExactOf<Test>;

  template <class... F>
  static std::vector<std::string_view> names_of(FormulaeList<F...>) {
    return {F::name...};
  }

  // A float widens exactly.
  template <class Real>
  static Numbers<double> widened(const Numbers<Real>& q) {
    Numbers<double> wide(q.size());
    for (std::size_t k = 0; k < q.size(); ++k) wide[k] = static_cast<double>(q[k]);
    return wide;
  }

  template <class T, class Real>
  static auto problem_of(const Numbers<Real>& q) {
    return Test::template problem<T>([&](std::size_t k) { return T(q[k]); });
  }

  template <class F, class Real>
  static ExactSides exact_sides(const Numbers<Real>& q) {
    const std::size_t count = Test::description().comparisons.size();
    ExactSides sides{std::vector<Rational>(count), std::vector<Rational>(count)};
    const auto keep = [&](std::size_t i, const Exact& lhs, const Exact& rhs) {
      if (lhs.value == rhs.value) sides.ties |= one_bit<ComparisonBits>(i);
      sides.lhs[i] = lhs.rational();
      sides.rhs[i] = rhs.rational();
    };
    sides.holds = bits_of<F, Exact>(problem_of<Exact>(q), keep);
    return sides;
  }

  // Exact signs alone, for which no side has to be kept: lhs > rhs, or lhs >= rhs where the formulae say so; lhs ==
  // rhs.
  struct Signs {
    ComparisonBits holds = 0, ties = 0;
    ComparisonBits strict() const { return holds & ~ties; }
  };
  template <class First, class... Rest, class Real>
  static Signs theorem_signs(const Numbers<Real>& q, FormulaeList<First, Rest...>) {
    Signs signs;
    const auto keep = [&](std::size_t i, const Exact& lhs, const Exact& rhs) {
      if (lhs.value == rhs.value) signs.ties |= one_bit<ComparisonBits>(i);
    };
    signs.holds = bits_of<First, Exact>(problem_of<Exact>(q), keep);
    return signs;
  }

  template <class Real>
  static std::string reason(const Numbers<Real>& q) {
    if constexpr (SaysWhyInvalid<Test>) return Test::why_invalid(widened(q));
    else return {};
  }

  template <class Real>
  static Truth truth_of(const Numbers<Real>& q) {
    const TestEntry& entry = Test::description().entries[entry_of<Test>()];
    if (q.size() != entry.columns.size()) {
      throw HarnessFault(fmt::format("{}: the oracles of entry {}, of {} columns, are asked about {} numbers",
                                     Test::description().id, entry.name, entry.columns.size(), q.size()));
    }
    const Numbers<double> wide = widened(q);
    if (!Test::is_valid(wide)) return {Verdict::invalid, false};
    const Truth truth = Test::geometric_truth(wide);
    const Signs signs = theorem_signs(q, typename Test::AllFormulae());
    const std::string wrong = Test::contradiction(wide, truth, signs.holds, signs.ties);
    if (!wrong.empty()) {
      throw OracleDisagreement(fmt::format("{}: {}", Test::description().id, wrong), q, Test::description());
    }
    return truth;
  }

  template <class Real, class... F>
  static std::optional<Claimed> claimed_by(const Kernel& kernel, const Numbers<Real>& q, FormulaeList<F...>) {
    if (kernel.claims.empty()) return std::nullopt;
    std::optional<Claimed> found;
    const auto evaluate = [&]<class One>() {
      if (!found && One::name == kernel.claims) found = evaluated<One>(kernel, q);
    };
    (evaluate.template operator()<F>(), ...);
    if (found) return found;
    throw HarnessFault(
        fmt::format("kernel '{}' claims formulae '{}', which {} has not", kernel.id, kernel.claims, kernel.test->id));
  }

  // R-infinity is by MPFR, whose exponents have no end that a query could reach.
  template <class F, class Real>
  static Claimed evaluated(const Kernel& kernel, const Numbers<Real>& q) {
    Claimed claim;
    claim.sides = exact_sides<F>(q);
    if (F::kind == FormulaeKind::rung) require_same_signs(F::name, *claim.sides, q);
    claim.chain = {outcome(claim.sides->holds), std::nullopt, claim.sides->ties};
    if (!kernel.is_reference) return claim;
    constexpr auto ignore = [](std::size_t, const auto&, const auto&) {};
    const FloatingScope scope({std::numeric_limits<Real>::digits, Rounding::nearest, {}});
    claim.chain.rounded = Rounded{outcome(bits_of<F, Floating>(problem_of<Floating>(q), ignore)),
                                  outcome(bits_of<F, Real>(problem_of<Real>(q), ignore))};
    return claim;
  }
  static Outcome outcome(ComparisonBits bits) { return {verdict_of(Test::description(), bits), bits}; }

  template <class Real>
  static void require_same_signs(std::string_view name, const ExactSides& rung, const Numbers<Real>& q) {
    const Signs first = theorem_signs(q, typename Test::AllFormulae()), signs{rung.holds, rung.ties};
    if (signs.strict() == first.strict() && signs.ties == first.ties) return;
    throw OracleDisagreement(
        fmt::format("{}: formulae {} have the exact signs {:#b} ties {:#b}, the first formulae {:#b} ties {:#b} (bit 0 "
                    "is the first comparison)",
                    Test::description().id, name, signs.strict(), signs.ties, first.strict(), first.ties),
        q, Test::description());
  }

  template <class Real>
  static std::optional<double> depth_of(const Numbers<Real>& q) {
    if constexpr (HasDepth<Test>) return Test::depth(widened(q));
    else return std::nullopt;
  }
  template <class Real>
  static std::vector<Detail> details_of(const Numbers<Real>& q) {
    if constexpr (HasDetails<Test, Real>) return Test::template details<Real>(widened(q));
    else return {};
  }
  template <class Real>
  static bool promises(const MotionPolicy& policy, const Numbers<Real>& q) {
    if constexpr (HasMotionPolicy<Test>) return policy == MotionPolicy{} || Test::is_promised(policy, widened(q));
    else return true;
  }
  template <class Real>
  static std::unique_ptr<MotionJudge> motion_judge_of(const Numbers<Real>& q) {
    if constexpr (HasMotionJudge<Test, Real>) return Test::template motion_judge<Real>(widened(q));
    else return nullptr;
  }
};

}  // namespace axiscert
