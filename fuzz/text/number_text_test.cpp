// Lengths with a unit: read, and printed in the unit that leaves three digits.
#include "fuzz/text/number_text.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "fuzz/queries/random.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

template <class Real>
auto bits(Real x) {
  return std::bit_cast<BitsOf<Real>>(x);
}

template <class Real>
std::string number_refusal(std::string_view text) {
  try {
    return "accepted as " + format_number(parse_number<Real>(text));
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

TEST(NumberText, WritesTheFewestHexDigits) {
  EXPECT_EQ(format_number(0.1875f), "0x1.8p-3");
  EXPECT_EQ(format_number(1.0), "0x1p+0");
  EXPECT_EQ(format_number(-1.0f), "-0x1p+0");
  EXPECT_EQ(format_number(0.2f), "0x1.99999ap-3");
  EXPECT_EQ(format_number(0.2), "0x1.999999999999ap-3");
  EXPECT_EQ(format_number(0.0), "0x0p+0");
  EXPECT_EQ(format_number(-0.0f), "-0x0p+0");
  EXPECT_EQ(format_number(0x1p-149f), "0x1p-149");
  EXPECT_EQ(format_number(0x1p-1074), "0x1p-1074");
  EXPECT_EQ(format_number(-0x1.8p-1073), "-0x1.8p-1073");
  EXPECT_EQ(format_number(std::numeric_limits<float>::max()), "0x1.fffffep+127");
  EXPECT_EQ(format_number(std::numeric_limits<double>::max()), "0x1.fffffffffffffp+1023");
  EXPECT_EQ(format_number(std::numeric_limits<float>::infinity()), "inf");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::infinity()), "-inf");
  EXPECT_EQ(format_number(-std::numeric_limits<double>::quiet_NaN()), "nan");
}

template <class Real>
void round_trip() {
  Stream random(1, name_hash("number_text_test"), 1, precision_of<Real>, 0);
  for (int i = 0; i < 20000; ++i) {
    auto pattern = static_cast<BitsOf<Real>>(random.bits());
    if (i % 4 == 0) pattern &= (BitsOf<Real>{1} << (std::numeric_limits<Real>::digits - 1)) - 1;  // subnormal
    const Real x = std::bit_cast<Real>(pattern);
    const std::string text = format_number(x);
    const Real back = parse_number<Real>(text);
    if (std::isnan(x)) {
      EXPECT_TRUE(std::isnan(back)) << text;
    } else {
      ASSERT_EQ(bits(x), bits(back)) << text;
    }
  }
}
TEST(NumberText, EveryBinary32BitPatternReadsBackTheSame) { round_trip<float>(); }
TEST(NumberText, EveryBinary64BitPatternReadsBackTheSame) { round_trip<double>(); }

// from_chars is independent code; it gives no result for numbers out of range, so those are tested separately below.
template <class Real>
void decimals_like_from_chars() {
  Stream random(1, name_hash("number_text_test"), 1, precision_of<Real>, 1);
  for (int i = 0; i < 20000; ++i) {
    std::string text = random.coin() ? "-" : "";
    const std::uint64_t digits = 1 + random.below(30), point = random.below(31);
    for (std::uint64_t k = 0; k < digits; ++k) {
      if (k == point) text += '.';
      text += static_cast<char>('0' + random.below(10));
    }
    if (random.coin()) text += "e" + std::to_string(random.integer(-60, 20));
    Real expected;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), expected);
    if (problem != std::errc()) continue;
    ASSERT_EQ(end, text.data() + text.size()) << text;
    ASSERT_EQ(bits(parse_number<Real>(text)), bits(expected)) << text;
  }
}
TEST(NumberText, DecimalsRoundAsALiteralDoes) {
  decimals_like_from_chars<float>();
  decimals_like_from_chars<double>();
  EXPECT_EQ(parse_number<float>("0.2"), 0.2f);
  EXPECT_EQ(parse_number<double>("0.2"), 0.2);
  EXPECT_EQ(parse_number<float>("1."), 1.0f);
  EXPECT_EQ(parse_number<float>(".5E+1"), 5.0f);
  EXPECT_EQ(bits(parse_number<float>("-0")), bits(-0.0f));
  EXPECT_EQ(bits(parse_number<double>("-0.0e99999999999999999999")), bits(-0.0));
}

TEST(NumberText, ABinary32DecimalIsNotRoundedThroughBinary64) {
  // Just above the midpoint between 1 and its successor; conversion through binary64 would round it to that midpoint,
  // then to even.
  EXPECT_EQ(parse_number<float>("1.00000005960464477540"), 0x1.000002p+0f);
  EXPECT_EQ(static_cast<float>(parse_number<double>("1.00000005960464477540")), 1.0f);
}

TEST(NumberText, DecimalsReachSubnormalsAndZeroCorrectly) {
  EXPECT_EQ(parse_number<float>("1e-45"), 0x1p-149f);
  EXPECT_EQ(parse_number<float>("7.1e-46"), 0x1p-149f);  // above half of the least subnormal, 7.006e-46
  EXPECT_EQ(parse_number<float>("7.0e-46"), 0.0f);
  EXPECT_EQ(parse_number<float>("1.17549421e-38"), 0x1.fffffcp-127f);  // the greatest subnormal
  EXPECT_EQ(parse_number<double>("4.9e-324"), 0x1p-1074);
  EXPECT_EQ(parse_number<double>("2.4e-324"), 0.0);
  EXPECT_EQ(bits(parse_number<double>("-1e-999999999999999999999")), bits(-0.0));
  EXPECT_EQ(parse_number<float>("0." + std::string(100000, '0') + "1e100001"), 1.0f);
  // 2^-1075, the midpoint between zero and the least binary64 number, truncated and rounded up.
  EXPECT_EQ(parse_number<double>("2.4703282292062327208e-324"), 0.0);
  EXPECT_EQ(parse_number<double>("2.4703282292062327209e-324"), 0x1p-1074);
  // A midpoint of binary32 is rounded to even; with one more nonzero digit in the five-thousandth place it is rounded
  // up.
  const std::string midpoint = "1.00000005960464477539062500" + std::string(5000, '0');
  EXPECT_EQ(parse_number<float>(midpoint), 1.0f);
  EXPECT_EQ(parse_number<float>(midpoint + "1"), 0x1.000002p+0f);
}

TEST(NumberText, DecimalsBeyondTheRangeAreErrors) {
  EXPECT_EQ(parse_number<float>("3.4028235e38"), std::numeric_limits<float>::max());
  EXPECT_EQ(parse_number<float>("3.4028235677973366163e38"), std::numeric_limits<float>::max());  // below the midpoint
  EXPECT_EQ(number_refusal<float>("3.4028235677973366164e38"),
            "3.4028235677973366164e38 overflows binary32; the greatest number is 0x1.fffffep+127");
  EXPECT_EQ(number_refusal<double>("-1e309"),
            "-1e309 overflows binary64; the greatest number is 0x1.fffffffffffffp+1023");
  EXPECT_NE(number_refusal<double>("1e99999999999999999999999").find("overflows"), std::string::npos);
}

TEST(NumberText, HexadecimalIsExactOrAnError) {
  EXPECT_EQ(parse_number<float>("0x1.99999ap-3"), 0.2f);
  EXPECT_EQ(parse_number<float>("0X1.99999AP-3"), 0.2f);
  EXPECT_EQ(parse_number<float>("0x.8p1"), 1.0f);
  EXPECT_EQ(parse_number<float>("0x0000010.p-4"), 1.0f);
  EXPECT_EQ(parse_number<float>("0x1." + std::string(100000, '0') + "p+0"), 1.0f);
  EXPECT_EQ(parse_number<float>("0x1" + std::string(100, '0') + "p-400"), 1.0f);
  EXPECT_EQ(parse_number<double>("0x0.0000000000001p-1022"), 0x1p-1074);
  EXPECT_EQ(bits(parse_number<float>("-0x0p+0")), bits(-0.0f));
  EXPECT_EQ(number_refusal<float>("0x1.9999999p-3"),
            "0x1.9999999p-3 is not exact in binary32; nearest is 0x1.99999ap-3");
  EXPECT_EQ(number_refusal<float>("-0x1.8p-149"), "-0x1.8p-149 is not exact in binary32; nearest is -0x1p-148");
  EXPECT_EQ(number_refusal<double>("0x1p-9999999999999999999"),
            "0x1p-9999999999999999999 is not exact in binary64; nearest is 0x0p+0");
  EXPECT_NE(number_refusal<double>("0x1." + std::string(1000, '0') + "1p+0").find("nearest is 0x1p+0"),
            std::string::npos);
  EXPECT_EQ(number_refusal<float>("0x1p+128"), "0x1p+128 overflows binary32; the greatest number is 0x1.fffffep+127");
  EXPECT_NE(number_refusal<float>("0x1.ffffffp+127").find("overflows"), std::string::npos);
  EXPECT_NE(number_refusal<float>("0x1p9999999999999999999").find("overflows"), std::string::npos);
}

TEST(NumberText, NoOtherSpellingIsANumber) {
  EXPECT_TRUE(std::isnan(parse_number<float>("nan")));
  EXPECT_EQ(parse_number<double>("inf"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_number<float>("-inf"), -std::numeric_limits<float>::infinity());
  for (const char* text : {"",    " ",        " 1",       "1 ",        "+1",    "+inf", "-nan",  "NaN",       "Inf",
                           "INF", "infinity", "Infinity", "nan(1)",    "-",     ".",    "-.",    "1e",        "1e+",
                           "e5",  "1,5",      "1.2.3",    "0x",        "0xp1",  "0x1p", "0x1p+", "0x1.8p-3f", "1.0f",
                           "--1", "0x-1p0",   "1p3",      "0x1e5p1.0", "1_000", "\t1",  "1\n",   "0b1"}) {
    const std::string message = number_refusal<float>(text);
    EXPECT_NE(message.find("is not a number"), std::string::npos) << "'" << text << "': " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(NumberText, WhatAMessageShowsIsOneShortLine) {
  EXPECT_EQ(shown("1.5"), "1.5");
  EXPECT_EQ(shown("a\nb\x7f"), "a\\nb\\u007f");
  EXPECT_LT(shown(std::string(1000000, '7')).size(), 100u);
  std::string umlauts;
  for (int i = 0; i < 59; ++i) umlauts += 'x';
  EXPECT_EQ(shown(umlauts + "\xc3\xa4tail"), umlauts + "... (65 characters)");
}

TEST(LengthUnit, IsChosenByTheSize) {
  EXPECT_EQ(metric_text(0.166), "16.6 cm");
  EXPECT_EQ(metric_text(1), "1 m");
  EXPECT_EQ(metric_text(0.9999), "1 m");
  EXPECT_EQ(metric_text(0.00123456), "1.23 mm");
  EXPECT_EQ(metric_text(1.2e-5), "12 um");
  EXPECT_EQ(metric_text(3e-8), "0.03 um");
  EXPECT_EQ(metric_text(3400), "3.4 km");
  EXPECT_EQ(metric_text(0), "0 m");
  EXPECT_EQ(metric_text(1e-40), "1e-40 m");
  EXPECT_EQ(metric_text(2e30), "2e+30 m");
}

TEST(LengthUnit, IsThatOfTheQueries) {
  EXPECT_EQ(length_text(16.6, find_length_unit("cm")), "16.6 cm");
  EXPECT_EQ(length_text(2, find_length_unit("ft")), "2 ft");
  EXPECT_EQ(length_text(0.166, nullptr), "0.166 units");
}

TEST(LengthUnit, IsReadAfterANumber) {
  EXPECT_EQ(length_in_metres("1mm"), 1e-3);
  EXPECT_EQ(length_in_metres("0.5 m"), 0.5);
  EXPECT_EQ(length_in_metres("2in"), 0.0508);
  for (const char* wrong : {"", "1", "mm", "1 mile", "-1mm", "0mm", "1mm ", "infm", "nanm", "1e999m"})
    EXPECT_EQ(length_in_metres(wrong), std::nullopt) << wrong;
}

}  // namespace
}  // namespace axiscert
