// Formats by name, each held to arithmetic that shares nothing with MPFR: an emulation that rounds after each
// operation, the processor's conversions and its own formats, and tables from the text of the OCP.
#include "exact/numbers/number_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <random>

#include "kernel/base/error.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace axiscert {
namespace {

double real(const Floating& x) { return mpfr_get_d(x.get(), MPFR_RNDN); }

FloatingScope scope_of(std::string_view format, RoundingRule rule = RoundingRule::nearest, std::uint64_t seed = 0) {
  return FloatingScope(floating(parse_number_format(format), rule, Precision::binary64, seed));
}

bool same(double found, double expected) {
  return std::isnan(expected) ? std::isnan(found) : found == expected && std::signbit(found) == std::signbit(expected);
}

// Emulation in binary64.

// The number of a format of so many bits nearest to x, ties to even.
double nearest_of(double x, int bits, int least, int greatest) {
  if (x == 0 || !std::isfinite(x)) return x;
  const int unit = std::max(std::ilogb(x), least) - bits + 1;
  const double rounded = std::ldexp(std::nearbyint(std::ldexp(x, -unit)), unit);
  const double most = std::ldexp(2 - std::ldexp(1.0, 1 - bits), greatest);
  return std::copysign(std::abs(rounded) > most ? HUGE_VAL : std::abs(rounded), x);
}

// a + b to odd: the last bit of the result is set where it is inexact, so that it can be rounded once more to at most
// 51 bits as if it were exact.
double sum_to_odd(double a, double b) {
  const double sum = a + b, of_b = sum - a, rest = (a - (sum - of_b)) + (b - of_b);
  if (!std::isfinite(sum) || rest == 0) return sum;
  auto bits = std::bit_cast<std::uint64_t>(sum);
  if ((bits & 1) == 0) bits += (rest > 0) == (sum > 0) ? 1 : -std::uint64_t{1};
  return std::bit_cast<double>(bits);
}

// The products of two numbers of at most 24 bits are exact in binary64. Quotients and roots are rounded twice, which
// changes nothing: 53 >= 2 p + 2 (S. A. Figueroa, "When is double rounding innocuous?", 1995), and where a quotient of
// numbers of p bits is no midpoint, it is further from one than 2^-(2 p + 1) of itself, also below the normal numbers.
double emulated(int operation, double a, double b, double c) {
  switch (operation) {
    case 0:
      return sum_to_odd(a, b);
    case 1:
      return sum_to_odd(a, -b);
    case 2:
      return a * b;
    case 3:
      return a / b;
    case 4:
      return sum_to_odd(a * b, c);
  }
  return std::sqrt(a);
}
Floating computed(int operation, double a, double b, double c) {
  switch (operation) {
    case 0:
      return Floating(a) + Floating(b);
    case 1:
      return Floating(a) - Floating(b);
    case 2:
      return Floating(a) * Floating(b);
    case 3:
      return Floating(a) / Floating(b);
    case 4:
      return fused(Floating(a), Floating(b), Floating(c));
  }
  return square_root(Floating(a));
}
constexpr int operations = 6;

struct Emulated {
  const char* name;
  int bits, least, greatest;
};
class NumberFormatEmulation : public testing::TestWithParam<Emulated> {};

TEST_P(NumberFormatEmulation, EveryOperationIsRoundedOnceToTheFormat) {
  const auto [format, bits, least, greatest] = GetParam();
  std::mt19937_64 random(81);
  // Half of the operands are of similar size, so that sums cancel; the others are anywhere, also subnormal.
  const auto operand = [&](int near) {
    const auto significand = static_cast<double>(random() >> 11) * 0x1p-53 + 1;
    const int anywhere = least - bits + static_cast<int>(random() % static_cast<unsigned>(greatest - least + bits + 1));
    const double x = std::ldexp(significand, random() % 2 == 0 ? anywhere : near + static_cast<int>(random() % 4));
    return nearest_of(random() % 2 == 0 ? x : -x, bits, least, greatest);
  };
  const FloatingScope scope = scope_of(format);
  std::array<int, 3> subnormal_infinite_inexact{};
  for (int i = 0; i < 40000; ++i) {
    const int near = least + static_cast<int>(random() % static_cast<unsigned>(greatest - least));
    const double a = operand(near), b = operand(near), c = operand(near);
    for (int operation = 0; operation < operations; ++operation) {
      const double wide = emulated(operation, a, b, c), expected = nearest_of(wide, bits, least, greatest);
      const double found = real(computed(operation, a, b, c));
      ASSERT_TRUE(same(found, expected)) << std::hexfloat << format << ", operation " << operation << " of " << a << ' '
                                         << b << ' ' << c << ": " << found << " for " << expected;
      subnormal_infinite_inexact[0] += expected != 0 && std::abs(expected) < std::ldexp(1.0, least);
      subnormal_infinite_inexact[1] += std::isinf(expected);
      subnormal_infinite_inexact[2] += expected != wide;
    }
  }
  for (const int seen : subnormal_infinite_inexact) EXPECT_GT(seen, 1000) << format;
}
INSTANTIATE_TEST_SUITE_P(Formats, NumberFormatEmulation,
                         testing::Values(Emulated{"bfloat16", 8, -126, 127}, Emulated{"binary16", 11, -14, 15},
                                         Emulated{"tf32", 11, -126, 127}, Emulated{"fp8-e5m2", 3, -14, 15},
                                         Emulated{"bits=5,emax=9", 5, -8, 9}, Emulated{"bits=2,emax=3", 2, -2, 3}),
                         [](const auto& of) { return "Format" + std::to_string(of.index); });

// The processor.

#if defined(__x86_64__)

// Floats anywhere in and around the format's range, with the midpoints of its numbers and their neighbours.
float float_near(std::mt19937_64& random, int bits, int least, int greatest) {
  const int exponent =
      least - bits - 2 + static_cast<int>(random() % static_cast<unsigned>(greatest - least + bits + 4));
  const auto significand = static_cast<double>(random() >> 11) * 0x1p-53 + 1;
  const double x = std::ldexp(significand, exponent);
  if (random() % 2 == 0) return static_cast<float>(x);
  const int unit = std::max(exponent, least) - bits;  // half a unit in the last place
  const auto middle = static_cast<float>(std::ldexp(std::floor(std::ldexp(x, -unit)), unit));
  const int step = static_cast<int>(random() % 3) - 1;
  return step == 0 ? middle : std::nextafter(middle, step > 0 ? HUGE_VALF : -HUGE_VALF);
}

template <int mode>
__attribute__((target("f16c"))) float through_half(float x) {
  return _cvtsh_ss(_cvtss_sh(x, mode));
}

TEST(NumberFormatHardware, Binary16IsTheProcessorsConversionInEveryRounding) {
  if (!__builtin_cpu_supports("f16c")) GTEST_SKIP() << "this processor has no F16C";
  const std::array<std::pair<RoundingRule, float (*)(float)>, 4> modes = {
      {{RoundingRule::nearest, through_half<_MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC>},
       {RoundingRule::up, through_half<_MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC>},
       {RoundingRule::down, through_half<_MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC>},
       {RoundingRule::zero, through_half<_MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC>}}};
  for (const auto& [rule, convert] : modes) {
    const FloatingScope scope = scope_of("binary16", rule);
    std::mt19937_64 random(82);
    for (int i = 0; i < 100000; ++i) {
      const float magnitude = float_near(random, 11, -14, 15), x = i % 2 == 0 ? magnitude : -magnitude;
      const double found = real(in_format(Floating(x)));
      ASSERT_TRUE(same(found, convert(x))) << std::hexfloat << name(rule) << " of " << x << ": " << found;
    }
  }
}

__attribute__((target("avx512bf16,avx512vl"))) float through_bfloat16(float x) {
  const __m128bh converted = _mm_cvtneps_pbh(_mm_set1_ps(x));
  const auto bits = static_cast<std::uint32_t>(_mm_cvtsi128_si32(std::bit_cast<__m128i>(converted))) << 16;
  return std::bit_cast<float>(bits);
}

TEST(NumberFormatHardware, Bfloat16IsTheProcessorsConversion) {
  if (!__builtin_cpu_supports("avx512bf16") || !__builtin_cpu_supports("avx512vl"))
    GTEST_SKIP() << "this processor has no AVX512-BF16";
  const FloatingScope scope = scope_of("bfloat16");
  std::mt19937_64 random(83);
  for (int i = 0; i < 200000; ++i) {
    const float magnitude = float_near(random, 8, -126, 126), x = i % 2 == 0 ? magnitude : -magnitude;
    if (std::fpclassify(x) == FP_SUBNORMAL) continue;  // which the instruction makes zero
    const double found = real(in_format(Floating(x)));
    ASSERT_TRUE(same(found, through_bfloat16(x))) << std::hexfloat << x << ": " << found;
  }
}

#endif

#if LDBL_MANT_DIG == 64 && LDBL_MAX_EXP == 16384

Floating wide(long double x) {
  const FloatingScope scope({64, Rounding::nearest, {}});
  if (!std::isfinite(x) || x == 0) return Floating(static_cast<double>(x));
  int exponent = 0;
  const long double significand = std::frexp(x, &exponent);
  const auto high = static_cast<double>(significand);
  Floating all = Floating(high) + Floating(static_cast<double>(significand - static_cast<long double>(high)));
  const int step = exponent < 0 ? -1000 : 1000;
  for (; std::abs(exponent) > 1000; exponent -= step) all = all * Floating(std::ldexp(1.0, step));
  return all * Floating(std::ldexp(1.0, exponent));
}

TEST(NumberFormatHardware, X87IsLongDouble) {
  std::mt19937_64 random(84);
  const auto operand = [&](int near) {
    const long double significand = static_cast<long double>(random() | (std::uint64_t{1} << 63)) * 0x1p-63L;
    const int exponent =
        random() % 2 == 0 ? static_cast<int>(random() % 32800) - 16450 : near + static_cast<int>(random() % 5);
    return std::ldexp(random() % 2 == 0 ? significand : -significand, exponent);
  };
  const FloatingScope scope = scope_of("x87");
  int subnormal = 0, infinite = 0;
  for (int i = 0; i < 30000; ++i) {
    // Half of them near the least numbers.
    const int near = i % 2 == 0 ? static_cast<int>(random() % 32600) - 16400 : static_cast<int>(random() % 60) - 16460;
    volatile long double a = operand(near), b = operand(near);
    const Floating x = wide(a), y = wide(b);
    const std::array<std::pair<long double, Floating>, 5> results = {
        {{a + b, x + y},
         {a - b, x - y},
         {a * b, x * y},
         {a / b, x / y},
         {std::sqrt(static_cast<long double>(a)), square_root(x)}}};
    for (std::size_t k = 0; k < results.size(); ++k) {
      const long double expected = results[k].first, found = mpfr_get_ld(results[k].second.get(), MPFR_RNDN);
      ASSERT_TRUE(std::isnan(expected) ? std::isnan(found) : found == expected)
          << std::hexfloat << "operation " << k << " of " << a << ' ' << b << ": " << found << " for " << expected;
      subnormal += std::fpclassify(expected) == FP_SUBNORMAL;
      infinite += std::isinf(expected);
    }
  }
  EXPECT_GT(subnormal, 100);
  EXPECT_GT(infinite, 100);
}

#endif

// OCP 8-bit Floating Point Specification (OFP8) 1.0, by its tables of values:
//   E4M3: exponent bias 7; NaN S.1111.111; greatest S.1111.110 = 448; no infinity
//   E5M2: exponent bias 15; infinity S.11111.00; NaN S.11111.{01, 10, 11}; greatest S.11110.11 = 57344
struct Ofp8 {
  int exponent_bits, significand_bits, bias;

  // The value of a code without a sign; NaN where it is none, and infinity.
  double value(int code) const {
    const int exponent = code >> significand_bits, significand = code & ((1 << significand_bits) - 1);
    const int last = (1 << exponent_bits) - 1;
    const bool is_e4m3 = exponent_bits == 4;
    if (is_e4m3 && exponent == last && significand == 7) return NAN;
    if (!is_e4m3 && exponent == last) return significand == 0 ? HUGE_VAL : NAN;
    const double fraction = significand / std::ldexp(1.0, significand_bits);
    return exponent == 0 ? std::ldexp(fraction, 1 - bias) : std::ldexp(1 + fraction, exponent - bias);
  }
  // The nearest finite number by search, of two the one with an even code; beyond them, where the next number would be
  // nearer, or as near and even, the code after the greatest.
  double nearest(double x, int greatest_code) const {
    if (!std::isfinite(x)) return x;
    double best = HUGE_VAL, found = 0;
    for (int code = 0; code <= greatest_code + 1; ++code) {
      // What follows the greatest number in the pattern of the others.
      const double step = value(greatest_code) - value(greatest_code - 1);
      const double number = code <= greatest_code ? value(code) : value(greatest_code) + step;
      const double distance = std::abs(std::abs(x) - number);
      if (distance > best || (distance == best && code % 2 != 0)) continue;
      best = distance;
      found = code <= greatest_code ? number : HUGE_VAL;
    }
    return std::copysign(std::abs(x) > 2 * value(greatest_code) ? HUGE_VAL : found, x);
  }
};
constexpr Ofp8 ofp8_e4m3{4, 3, 7}, ofp8_e5m2{5, 2, 15};

TEST(NumberFormatOcp, HasTheNumbersOfTheText) {
  EXPECT_EQ(ofp8_e4m3.value(0b1111110), 448);
  EXPECT_EQ(ofp8_e4m3.value(0b0001000), 0x1p-6);
  EXPECT_EQ(ofp8_e4m3.value(0b0000111), 0.875 * 0x1p-6);
  EXPECT_EQ(ofp8_e4m3.value(0b0000001), 0x1p-9);
  EXPECT_EQ(ofp8_e5m2.value(0b1111011), 57344);
  EXPECT_EQ(ofp8_e5m2.value(0b0000100), 0x1p-14);
  EXPECT_EQ(ofp8_e5m2.value(0b0000011), 0.75 * 0x1p-14);
  EXPECT_EQ(ofp8_e5m2.value(0b0000001), 0x1p-16);
}

// All pairs of numbers. Sums, differences and products of two are exact in binary64.
void expect_table(const char* format, const Ofp8& table, int greatest_code, double beyond) {
  const FloatingScope scope = scope_of(format);
  int overflows = 0;
  const auto expect = [&](const Floating& found, double exact) {
    double expected = table.nearest(exact, greatest_code);
    if (std::isinf(expected)) {
      ++overflows;
      expected = std::copysign(beyond, expected);
    }
    ASSERT_TRUE(same(real(found), expected))
        << std::hexfloat << format << ": " << exact << " is " << real(found) << " and should be " << expected;
  };
  for (int i = 0; i <= greatest_code; ++i) {
    for (int j = 0; j <= greatest_code; ++j) {
      const double a = table.value(i), b = table.value(j);
      expect(Floating(a) + Floating(b), a + b);
      expect(Floating(a) - Floating(b), a - b);
      expect(Floating(a) * Floating(b), a * b);
      if (b != 0) expect(Floating(a) / Floating(b), a / b);
    }
  }
  EXPECT_GT(overflows, 1000);
  const Floating infinite = Floating(1) / Floating(0);
  EXPECT_TRUE(same(real(infinite), beyond)) << real(infinite);
}

TEST(NumberFormatOcp, E4m3HasNoInfinityAndNoNumberWhereItsNanIs) {
  expect_table("fp8-e4m3", ofp8_e4m3, 0b1111110, NAN);
  const FloatingScope scope = scope_of("fp8-e4m3");
  EXPECT_EQ(real(in_format(Floating(464))), 448) << "half way to 480, which is NaN's place; 448 is even";
  EXPECT_TRUE(std::isnan(real(in_format(Floating(464.0001)))));
  const FloatingScope down = scope_of("fp8-e4m3", RoundingRule::zero);
  EXPECT_EQ(real(in_format(Floating(479))), 448);
  EXPECT_EQ(real(in_format(Floating(1e6))), 448) << "toward zero nothing overflows";
}
TEST(NumberFormatOcp, E4m3Saturates) { expect_table("fp8-e4m3-saturating", ofp8_e4m3, 0b1111110, 448); }
TEST(NumberFormatOcp, E5m2HasInfinities) { expect_table("fp8-e5m2", ofp8_e5m2, 0b1111011, HUGE_VAL); }
TEST(NumberFormatOcp, E5m2Saturates) { expect_table("fp8-e5m2-saturating", ofp8_e5m2, 0b1111011, 57344); }

// Chance.

TEST(NumberFormatChance, FaithfulAndStochasticResultsAreTheTwoNeighboursAndExactOnesStay) {
  for (const char* format : {"binary16", "bits=24", "fp8-e5m2", "bits=80,emax=300"}) {
    std::mt19937_64 random(85);
    int inexact = 0, up_of_faithful = 0, up_of_stochastic = 0;
    for (int i = 0; i < 4000; ++i) {
      const auto any = [&] {
        return std::ldexp(static_cast<double>(random() >> 11), -53 - static_cast<int>(random() % 18));
      };
      const double a = i % 2 == 0 ? any() : -any(), b = any();
      const auto by = [&](RoundingRule rule) {
        const FloatingScope scope = scope_of(format, rule, random());
        const Floating x(a), y(b);
        return i % 4 == 0 ? x + y : i % 4 == 1 ? x * y : i % 4 == 2 ? x / y : square_root(magnitude(x));
      };
      const Floating low = by(RoundingRule::down), high = by(RoundingRule::up);
      const bool is_inexact = mpfr_equal_p(low.get(), high.get()) == 0;
      inexact += is_inexact;
      for (const RoundingRule rule : {RoundingRule::faithful, RoundingRule::stochastic}) {
        const Floating found = by(rule);
        const bool is_high = mpfr_equal_p(found.get(), high.get()) != 0;
        // The root is of a magnitude that is rounded by the same rule: it has other neighbours.
        if (i % 4 == 3) continue;
        ASSERT_TRUE(is_high || mpfr_equal_p(found.get(), low.get()) != 0)
            << std::hexfloat << format << ' ' << name(rule) << " of " << a << ' ' << b << ": " << real(found);
        (rule == RoundingRule::faithful ? up_of_faithful : up_of_stochastic) += is_inexact && is_high;
      }
    }
    EXPECT_GT(inexact, 2000) << format;
    for (const int up : {up_of_faithful, up_of_stochastic}) {
      EXPECT_GT(up, 900) << format;
      EXPECT_LT(up, inexact - 900) << format;
    }
  }
}

// The share of results that are rounded up is the exact fraction, within five standard deviations.
void expect_share(const char* format, double x, double low, double high, double share, RoundingRule rule) {
  constexpr int draws = 20000;
  const FloatingScope scope = scope_of(format, rule, 7);
  int up = 0;
  for (int i = 0; i < draws; ++i) {
    const double found = real(in_format(Floating(x)));
    ASSERT_TRUE(found == low || found == high) << std::hexfloat << found;
    up += found == high;
  }
  EXPECT_NEAR(up, share * draws, 5 * std::sqrt(draws * share * (1 - share)) + 1e-9) << format << ' ' << x;
}

TEST(NumberFormatChance, StochasticProbabilitiesAreTheDistances) {
  const auto stochastic = RoundingRule::stochastic;
  expect_share("binary16", 1 + 0x1p-12, 1, 1 + 0x1p-10, 0.25, stochastic);
  expect_share("binary16", -(1 + 0x1p-12), -1, -(1 + 0x1p-10), 0.25, stochastic);
  expect_share("bfloat16", 1 + 0x1p-7 * 0.9, 1, 1 + 0x1p-7, 0.9, stochastic);
  expect_share("binary16", 0x1p-24 * 0.125, 0, 0x1p-24, 0.125, stochastic);
  expect_share("binary16", 0x1p-24 * 3.75, 0x1.8p-23, 0x1p-22, 0.75, stochastic);
  expect_share("binary16", 65504 + 8, 65504, HUGE_VAL, 0.25, stochastic);
  expect_share("fp8-e5m2-saturating", 57344 + 4096, 57344, 57344, 1, stochastic);
  expect_share("binary16", 1 + 0x1p-12, 1, 1 + 0x1p-10, 0.5, RoundingRule::faithful);
  expect_share("binary16", 1.5, 1.5, 1.5, 1, stochastic);
}

TEST(NumberFormatChance, ASeedGivesTheSameNumbersAgain) {
  const auto draw = [](std::uint64_t seed) {
    const FloatingScope scope = scope_of("bfloat16", RoundingRule::stochastic, seed);
    std::uint64_t ups = 0;
    for (int i = 0; i < 64; ++i) ups = ups * 2 + (real(Floating(1) / Floating(3)) > 1.0 / 3);
    return ups;
  };
  EXPECT_EQ(draw(1), draw(1));
  EXPECT_NE(draw(1), draw(2));
}

// Names.

TEST(NumberFormatNames, AreWhatTheyWere) {
  for (const NamedFormat& each : named_formats()) EXPECT_EQ(parse_number_format(each.format.name), each.format);
  const NumberFormat half = parse_number_format("bits=11,emax=15");
  EXPECT_EQ(half.exponents, parse_number_format("binary16").exponents);
  EXPECT_EQ(parse_number_format("bits=4096").bits, 4096);
  EXPECT_FALSE(parse_number_format("bits=24").exponents);
  EXPECT_EQ(floating(format_of_bits(24), RoundingRule::nearest, Precision::binary32).exponents,
            parse_number_format("binary32").exponents);
}

TEST(NumberFormatNames, AreRefusedWithWhatWouldBeRight) {
  const auto refusal = [](std::string_view text) {
    try {
      parse_number_format(text);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("taken");
  };
  using testing::AllOf, testing::HasSubstr;
  EXPECT_THAT(refusal("bfloat"), AllOf(HasSubstr("'bfloat'"), HasSubstr("did you mean 'bfloat16'")));
  EXPECT_THAT(refusal("bits=1"), AllOf(HasSubstr("'1'"), HasSubstr("2 to 4096")));
  EXPECT_THAT(refusal("bits=4097,emax=3"), HasSubstr("2 to 4096"));
  EXPECT_THAT(refusal("bits=8,emax=0"), AllOf(HasSubstr("emax"), HasSubstr("from 1 to")));
  EXPECT_THAT(refusal("bits=8,emin=3"), AllOf(HasSubstr("emin=3"), HasSubstr("emax=E")));
  EXPECT_THAT(refusal("bits="), HasSubstr("bits= takes a whole number"));
  EXPECT_THAT(refusal("emax=3,bits=8"), HasSubstr("bits=11,emax=15"));
}

// Precisions far beyond the machine's: 4096 bits.
TEST(NumberFormatWide, RoundsAtTheLastOf4096Bits) {
  const FloatingScope scope = scope_of("bits=4096,emax=100000");
  Floating small(1);
  for (int i = 0; i < 4095; ++i) small = small * Floating(0.5);
  EXPECT_GT(Floating(1) + small, Floating(1));
  EXPECT_FALSE(Floating(1) + small * Floating(0.5) > Floating(1)) << "a tie goes to even";
}

}  // namespace
}  // namespace axiscert
