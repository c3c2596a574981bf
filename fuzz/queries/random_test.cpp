// The random numbers are Random123's, and no two generators share them.
#include "fuzz/queries/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "fuzz/queries/family.h"

namespace axiscert {
namespace {

using Counter = r123::Philox4x32::ctr_type;
using Key = r123::Philox4x32::key_type;

// From kat_vectors of Random123, the lines "philox4x32 10".
struct KnownAnswer {
  Counter counter;
  Key key;
  Counter words;
};
const KnownAnswer known_answers[] = {
    {{{0, 0, 0, 0}}, {{0, 0}}, {{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}}},
    {{{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}},
     {{0xffffffff, 0xffffffff}},
     {{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}}},
    {{{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}},
     {{0xa4093822, 0x299f31d0}},
     {{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}}},
};

TEST(Random, PhiloxGivesTheKnownAnswers) {
  for (const KnownAnswer& known : known_answers) EXPECT_EQ(r123::Philox4x32()(known.counter, known.key), known.words);
}

TEST(Random, CounterAndKeyAreLaidOutAsStated) {
  const std::uint64_t seed = 0x0123456789abcdef, hash = 0x1111222233334444, position = 0xfedcba9876543210;
  Stream random(seed, hash, 5, Precision::binary64, position);
  for (std::uint32_t block = 0; block < 3; ++block) {
    const Counter counter = {{0x76543210, 0xfedcba98, 0x22226666, 0x80500000u | block}};
    const Counter words = r123::Philox4x32()(counter, {{0x89abcdef, 0x01234567}});
    for (const std::uint32_t expected : words) EXPECT_EQ(random.word(), expected) << "block " << block;
  }
}

TEST(Random, NoTwoFamiliesShareAStream) {
  std::map<std::uint32_t, std::string_view> words;
  for (const Family* family : families()) {
    const StreamName name(1, name_hash(family->name), family->version, Precision::binary32);
    const auto [before, is_new] = words.emplace(name.generator, family->name);
    EXPECT_TRUE(is_new) << family->name << " and " << before->second << " have the counter word " << name.generator;
    EXPECT_LT(family->version, 1 << 11);
    EXPECT_NE(name.kind, StreamName(1, name_hash(family->name), family->version, Precision::binary64).kind);
  }
}

// The definitions, compared with the words of an equal stream.
TEST(Random, NumbersAreTheBitsTheyAreSaidToBe) {
  for (std::uint64_t position = 0; position < 1000; ++position) {
    const auto stream = [&] { return Stream(20260101, 7, 1, Precision::binary32, position); };
    Stream words = stream(), floats = stream(), doubles = stream(), small = stream(), large = stream();
    for (int i = 0; i < 8; ++i) {
      const std::uint32_t high = words.word(), low = words.word();
      const std::uint64_t both = std::uint64_t{high} << 32 | low;
      EXPECT_EQ(floats.unit<float>(), std::ldexp(static_cast<float>(high >> 8), -24));
      const float x = floats.symmetric<float>();
      EXPECT_EQ(std::abs(x), std::ldexp(static_cast<float>(low >> 8), -24));
      EXPECT_EQ(std::signbit(x), (low & 1) != 0);
      const double y = doubles.symmetric<double>();
      EXPECT_EQ(std::abs(y), std::ldexp(static_cast<double>(both >> 11), -53));
      EXPECT_EQ(std::signbit(y), (low & 1) != 0);
      EXPECT_EQ(small.below(7), std::uint64_t{high} * 7 >> 32);
      EXPECT_EQ(small.coin(), low >= 0x80000000u);
      const auto n = std::uint64_t{1} << 40;
      EXPECT_EQ(large.below(n), both >> 24);
    }
  }
}

}  // namespace
}  // namespace axiscert
