// Oracles made of a trait: the chain of a claim link by link, and disagreements that have to end a run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/judge/oracles_of.h"
#include "exact/judge/side_error.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// a a + b > c separates; the entry's numbers are a, b, c.
struct Sum {
  static const Predicate& description() {
    static const Predicate predicate =
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
    return predicate;
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

// The same, made from the first: what was evaluated of these is not evaluated again.
struct TiedSum : AsWritten {
  static constexpr std::string_view name = "tied";
  static constexpr ComparisonBits nonstrict = 1;
};

template <int wrong_by>
struct SumTrait : Sum {
  using AllFormulae = FormulaeList<AsWritten, Slip, Variant, AtLeast, TiedSum>;
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
  Kernel kernel = formulae_kernel<Sum, AsWritten>("sum/one", "");
  kernel.formulae = std::move(formulae);
  kernel.is_reference = is_reference;
  return kernel;
}

const OraclesOf<SumTrait<0>> of_sums;
const Oracles& oracles = of_sums;

TEST(Trait, TruthIsThatOfTheGeometry) {
  EXPECT_EQ(oracles.truth(Numbers<double>{2, 0, 3}).verdict, Verdict::separated);
  EXPECT_TRUE(oracles.truth(Numbers<double>{2, 0, 4}).touching);
  EXPECT_EQ(oracles.truth(Numbers<float>{2, INFINITY, 4}).verdict, Verdict::invalid);
  EXPECT_EQ(oracles.depth(Numbers<double>{2, 0, 3}), std::nullopt);
}

TEST(Trait, EachLinkOfAChainIsTheOneThatBroke) {
  const Kernel kernel = claiming("as-written");
  const auto bits = [&](const auto& numbers) {
    const Reference chain = *oracles.about(numbers)->chain(kernel);
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
  const auto asked = oracles.about(Numbers<double>{0.5, 0, 0.25});
  const Reference chain = *asked->chain(claiming("as-written", false));
  EXPECT_EQ(chain.rounded, std::nullopt);
  EXPECT_EQ(chain.ties, 1u);
  EXPECT_EQ(rational(asked->sides(claiming("as-written", false))->lhs[0]), Rational(1, 4));
  EXPECT_EQ(asked->chain(claiming("")), std::nullopt);
  EXPECT_EQ(asked->sides(claiming("")), nullptr);
  EXPECT_THAT([&] { asked->chain(claiming("none")); },
              ThrowsMessage<HarnessFault>(HasSubstr("kernel 'sum/one' claims formulae 'none', which sum has not")));
}

TEST(Trait, ClaimsOfOneQueryAreEachOfTheirOwnFormulae) {
  const auto asked = oracles.about(Numbers<double>{0.5, 0, 0.25});
  EXPECT_EQ(asked->truth().verdict, Verdict::contact);
  // In any order, whatever was asked before.
  for (const bool first : {true, false, true}) {
    const Kernel kernel = claiming(first ? "as-written" : "at-least");
    const Reference chain = *asked->chain(kernel);
    EXPECT_EQ(chain.exact.bits, first ? 0u : 1u);
    EXPECT_EQ(chain.rounded->reference.bits, first ? 0u : 1u);
    EXPECT_EQ(asked->sides(kernel)->ties, 1u);
    EXPECT_EQ(rational(asked->sides(kernel)->lhs[0]), Rational(1, 4));
  }
  EXPECT_EQ(asked->sides(claiming("variant"))->ties, 1u);
  const auto apart = oracles.about(Numbers<double>{1, 0.5, 1});
  EXPECT_EQ(rational(apart->sides(claiming("variant"))->lhs[0]), Rational(1, 2));
  EXPECT_EQ(rational(apart->sides(claiming("at-least"))->lhs[0]), Rational(3, 2));
}

TEST(Trait, AnExpectedClaimIsTheSame) {
  for (const double c : {0.25, 0.125, 0.5}) {
    const Numbers<double> q{0.5, 0, c};
    const auto asked = oracles.about(q);
    asked->expect(claiming("tied"));
    EXPECT_EQ(asked->truth().touching, c == 0.25);
    for (const std::string formulae : {"tied", "as-written", "tied"}) {
      const Kernel kernel = claiming(formulae);
      const auto alone = oracles.about(q);
      EXPECT_EQ(asked->chain(kernel)->exact.bits, alone->chain(kernel)->exact.bits) << formulae << " at " << c;
      EXPECT_EQ(asked->chain(kernel)->exact.bits, c < 0.25 || (c == 0.25 && formulae == "tied") ? 1u : 0u);
      EXPECT_EQ(asked->sides(kernel)->ties, alone->sides(kernel)->ties) << formulae << " at " << c;
      EXPECT_EQ(rational(asked->sides(kernel)->lhs[0]), Rational(1, 4));
      EXPECT_EQ(rational(asked->sides(kernel)->rhs[0]), exact(c));
    }
  }
}

TEST(Trait, DisagreementsEndARun) {
  const Numbers<double> q{1, 1, 1.5};
  EXPECT_THAT([&] { OraclesOf<SumTrait<-1>>().truth(q); },
              ThrowsMessage<OracleDisagreement>(HasSubstr("sum: sum and bits differ")));
  EXPECT_THAT([&] { oracles.about(q)->chain(claiming("slip")); },
              ThrowsMessage<OracleDisagreement>(HasSubstr("formulae slip have the exact signs 0b0 ties 0b0, the first "
                                                          "formulae 0b1 ties 0b0")));
  EXPECT_EQ(*oracles.about(q)->chain(claiming("variant"))->exact.bits, 0u);
}

TEST(SideError, IsInUnitsOfUAndOfBothSides) {
  const auto side = [](double x) { return BinaryFraction(x); };
  const auto kind = [&](double lhs, double rhs, double exact) {
    return SideError(lhs, rhs, {side(exact), side(0)}).kind();
  };
  using enum SideError::Kind;
  EXPECT_EQ(kind(INFINITY, 0, 1), range_event);
  EXPECT_EQ(kind(1, 0, 0), without_scale);
  EXPECT_EQ(kind(0, 0, 0), finite);
  const SideError error(1 + 0x1p-23f, 1.0f, {side(1), side(1)});
  EXPECT_EQ(error.rounded_up().value(), 1);
  EXPECT_GE(error.upper(), 1);
  EXPECT_FALSE(error.exceeds(1));
  EXPECT_TRUE(error.exceeds(Rational(999, 1000)));
}

// a b against c d of any exponents and lengths, computed with a few ulps of error or none.
template <class Real>
void expect_bounds_of_errors(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto number = [&] {
    const double bits = static_cast<double>(random() >> (11 + random() % 53));
    return std::ldexp(random() % 2 == 0 ? bits : -bits, static_cast<int>(random() % 40) - 20);
  };
  for (int i = 0; i < 20000; ++i) {
    const int exponent = (random() % 2000 == 0 ? 500 : 8) * (static_cast<int>(random() % 9) - 4);
    const auto side = [&] {
      return BinaryNumber(number()) * BinaryNumber(number()) * BinaryNumber(std::ldexp(1, exponent / 4));
    };
    const BinaryFraction lhs(side()), rhs(random() % 4 == 0 ? lhs.over : side());
    const auto computed = [&](const BinaryFraction& exactly) {
      auto rounded = static_cast<Real>(rational(exactly).get_d());
      for (auto steps = random() % 3; steps > 0; --steps) rounded = std::nextafter(rounded, Real(random() % 2));
      return rounded;
    };
    const Real l = computed(lhs), r = computed(rhs);
    const double at_most = side_error_at_most(l, r, {lhs, rhs});
    const SideError error(l, r, {lhs, rhs});
    if (error.kind() != SideError::Kind::finite) {
      ASSERT_EQ(at_most, INFINITY) << i;
    } else if (std::isfinite(at_most)) {
      ASSERT_FALSE(error.exceeds(Rational(at_most))) << i;
      ASSERT_LE(at_most, error.upper() * (1 + 1e-6) + 0.05) << i;
    } else {
      ASSERT_TRUE(lhs.over.sign() == 0 && rhs.over.sign() == 0) << i;
    }
  }
  const BinaryFraction one(1.0), third = one / BinaryFraction(3.0);
  EXPECT_EQ(side_error_at_most(Real(1), Real(0), {third, one}), INFINITY) << "a quotient";
  EXPECT_EQ(side_error_at_most(std::numeric_limits<Real>::infinity(), Real(0), {one, one}), INFINITY);
  EXPECT_EQ(side_error_at_most(std::numeric_limits<Real>::quiet_NaN(), Real(0), {one, one}), INFINITY);
}
TEST(SideError, ABoundFromTheLeadingWordsHoldsAndIsClose) {
  expect_bounds_of_errors<float>(20261125);
  expect_bounds_of_errors<double>(20261126);
}

}  // namespace
}  // namespace axiscert
