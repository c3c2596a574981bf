// Oracles made of a trait: the chain of a claim link by link, and disagreements that have to end a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "exact/trait/oracles_of.h"
#include "exact/trait/side_error.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// a a + b > c separates; the entry's numbers are a, b, c.
struct Sum {
  static const TestDescription& description() {
    static const TestDescription test =
        checked({.id = "sum",
                 .asks = "is a a + b at most c",
                 .touching = "they are equal",
                 .wrong_answers = {},
                 .entries = {{"numbers",
                              "finite",
                              {{"a", Role::length, "a"}, {"b", Role::length, "b"}, {"c", Role::length, "c"}}}},
                 .comparisons = {{"more", 0}},
                 .clauses = {{"more", 1}},
                 .measures = {}});
    return test;
  }
  template <class T>
  struct Problem {
    T a, b, c;
  };
  template <class T, class Load>
  static Problem<T> problem(Load&& load) {
    return {load(0), load(1), load(2)};
  }
};
struct AsWritten {
  static constexpr std::string_view name = "as-written";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  template <class T, class Sink>
  static void comparisons(const Sum::Problem<T>& q, Sink& sink) {
    sink(0, q.a * q.a + q.b, q.c);
  }
};
// Planted: said to have the signs of the first, and has not.
struct Slip {
  static constexpr std::string_view name = "slip";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  template <class T, class Sink>
  static void comparisons(const Sum::Problem<T>& q, Sink& sink) {
    sink(0, q.a * q.a - q.b, q.c);
  }
};
// The same, and said to be other formulae: no disagreement.
struct Variant : Slip {
  static constexpr std::string_view name = "variant";
  static constexpr FormulaeKind kind = FormulaeKind::variant;
};

// The sides of the first, compared by >=.
struct AtLeast {
  static constexpr std::string_view name = "at-least";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  static constexpr ComparisonBits nonstrict = 1;
  template <class T, class Sink>
  static void comparisons(const Sum::Problem<T>& q, Sink& sink) {
    AsWritten::comparisons<T>(q, sink);
  }
};

template <int wrong_by>
struct SumTrait : Sum {
  using AllFormulae = FormulaeList<AsWritten, Slip, Variant, AtLeast>;
  static bool is_valid(const Numbers<double>& q) {
    return std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]);
  }
  static Truth geometric_truth(const Numbers<double>& q) {
    const Rational a(q[0]), excess = a * a + Rational(q[1]) - Rational(q[2]) + wrong_by;
    return {excess > 0 ? Verdict::separated : Verdict::contact, excess == 0};
  }
  static std::string contradiction(const Numbers<double>&, const Truth& truth, ComparisonBits holds,
                                   ComparisonBits ties) {
    const bool agrees = (truth.verdict == Verdict::separated) == (holds == 1) && truth.touching == (ties == 1);
    return agrees ? "" : "sum and bits differ";
  }
};

Kernel claiming(std::string formulae, bool is_reference = true) {
  Kernel kernel = plain_kernel<Sum, AsWritten>("sum/one", "");
  kernel.claims = std::move(formulae);
  kernel.is_reference = is_reference;
  return kernel;
}

const OraclesOf<SumTrait<0>> oracles;

TEST(Trait, TruthIsThatOfTheGeometry) {
  EXPECT_EQ(oracles.truth(Numbers<double>{2, 0, 3}).verdict, Verdict::separated);
  EXPECT_TRUE(oracles.truth(Numbers<double>{2, 0, 4}).touching);
  EXPECT_EQ(oracles.truth(Numbers<float>{2, INFINITY, 4}).verdict, Verdict::invalid);
  EXPECT_EQ(oracles.depth(Numbers<double>{2, 0, 3}), std::nullopt);
}

TEST(Trait, EachLinkOfAChainIsTheOneThatBroke) {
  const Kernel kernel = claiming("as-written");
  const auto bits = [&](const auto& numbers) {
    const Reference chain = *oracles.chain(kernel, numbers);
    return std::array{*chain.exact.bits, *chain.rounded->range_free.bits, *chain.rounded->reference.bits};
  };
  using Bits = std::array<ComparisonBits, 3>;
  EXPECT_EQ(bits(Numbers<double>{1, 0.5, 1}), (Bits{1, 1, 1}));
  EXPECT_EQ(bits(Numbers<double>{1, 0x1p-60, 1}), (Bits{1, 0, 0})) << "rounding";
  EXPECT_EQ(bits(Numbers<double>{0x1p-600, 0, 0}), (Bits{1, 1, 0})) << "range";
  EXPECT_EQ(bits(Numbers<float>{1, 0x1p-30f, 1}), (Bits{1, 0, 0})) << "rounding in binary32";
  EXPECT_EQ(bits(Numbers<float>{0x1p-80f, 0, 0}), (Bits{1, 1, 0})) << "range of binary32";
}

TEST(Trait, AClaimHasExactSidesAndTies) {
  const auto claim = oracles.claimed(claiming("as-written", false), Numbers<double>{0.5, 0, 0.25});
  EXPECT_EQ(claim->chain.rounded, std::nullopt);
  EXPECT_EQ(claim->chain.ties, 1u);
  EXPECT_EQ(rational(claim->sides->lhs[0]), Rational(1, 4));
  EXPECT_EQ(oracles.claimed(claiming(""), Numbers<double>{1, 1, 1}), std::nullopt);
  EXPECT_THAT(
      [] {
        oracles.claimed(claiming("none"), Numbers<double>{1, 1, 1});
      },
      ThrowsMessage<HarnessFault>(HasSubstr("kernel 'sum/one' claims formulae 'none', which sum has not")));
}

TEST(Trait, ClaimsOfOneQueryAreEachOfTheirOwnFormulae) {
  const auto asked = oracles.about(Numbers<double>{0.5, 0, 0.25});
  EXPECT_EQ(asked->truth().verdict, Verdict::contact);
  // In any order, whatever was asked before.
  for (const bool first : {true, false, true}) {
    const auto claim = asked->claimed(claiming(first ? "as-written" : "at-least"));
    EXPECT_EQ(claim->chain.exact.bits, first ? 0u : 1u);
    EXPECT_EQ(claim->chain.rounded->reference.bits, first ? 0u : 1u);
    EXPECT_EQ(claim->sides->ties, 1u);
    EXPECT_EQ(rational(claim->sides->lhs[0]), Rational(1, 4));
  }
  EXPECT_EQ(asked->claimed(claiming("variant"))->sides->ties, 1u);
  const auto apart = oracles.about(Numbers<double>{1, 0.5, 1});
  EXPECT_EQ(rational(apart->claimed(claiming("variant"))->sides->lhs[0]), Rational(1, 2));
  EXPECT_EQ(rational(apart->claimed(claiming("at-least"))->sides->lhs[0]), Rational(3, 2));
}

TEST(Trait, DisagreementsEndARun) {
  const Numbers<double> q{1, 1, 1.5};
  EXPECT_THAT([&] { OraclesOf<SumTrait<-1>>().truth(q); },
              ThrowsMessage<OracleDisagreement>(HasSubstr("sum: sum and bits differ")));
  EXPECT_THAT([&] { oracles.claimed(claiming("slip"), q); },
              ThrowsMessage<OracleDisagreement>(HasSubstr("formulae slip have the exact signs 0b0 ties 0b0, the first "
                                                          "formulae 0b1 ties 0b0")));
  EXPECT_EQ(*oracles.chain(claiming("variant"), q)->exact.bits, 0u);
}

TEST(SideError, IsInUnitsOfUAndOfBothSides) {
  const auto side = [](double x) { return BinaryFraction(x); };
  const auto kind = [&](double lhs, double rhs, double exact) {
    return SideError(lhs, rhs, side(exact), side(0)).kind();
  };
  using enum SideError::Kind;
  EXPECT_EQ(kind(INFINITY, 0, 1), range_event);
  EXPECT_EQ(kind(1, 0, 0), without_scale);
  EXPECT_EQ(kind(0, 0, 0), finite);
  const SideError error(1 + 0x1p-23f, 1.0f, side(1), side(1));
  EXPECT_EQ(error.rounded_up().value(), 1);
  EXPECT_GE(error.upper(), 1);
  EXPECT_FALSE(error.exceeds(1));
  EXPECT_TRUE(error.exceeds(Rational(999, 1000)));
}

}  // namespace
}  // namespace axiscert
