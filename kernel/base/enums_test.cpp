// EnumArray, EnumSet and the bits of words.
#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "kernel/base/enums.h"

namespace axiscert {
enum class Season : std::uint8_t { spring, summer, autumn, winter };
template <>
inline constexpr std::size_t enum_count<Season> = 4;

namespace {
using enum Season;
using Seasons = EnumSet<Season, std::uint8_t>;

static_assert(sizeof(EnumArray<Season, int>) == 4 * sizeof(int));
static_assert(sizeof(Seasons) == 1);
static_assert(Seasons{summer, winter}.bits() == 0b1010);
static_assert(EnumArray<Season, int>{1, 2, 3, 4}[autumn] == 3);

TEST(EnumArray, AnElementIsFoundByItsEnumeratorAndByItsNumber) {
  EnumArray<Season, std::string_view> names = {"spring", "summer", "autumn", "winter"};
  for (const Season season : enumerators<Season>) EXPECT_EQ(names[season], names[index_of(season)]);
  EXPECT_EQ(names[spring], "spring");
  EXPECT_EQ(names[winter], "winter");
  names[summer] = "long";
  EXPECT_EQ(names.data()[1], "long");
  EXPECT_EQ(std::vector<std::string_view>(names.begin(), names.end()),
            (std::vector<std::string_view>{"spring", "long", "autumn", "winter"}));
  EXPECT_EQ(names.size(), 4u);
}

TEST(EnumArray, EqualWhereEachElementIs) {
  EnumArray<Season, int> a{}, b{};
  EXPECT_EQ(a, b);
  b[winter] = 1;
  EXPECT_NE(a, b);
}

TEST(EnumArray, EnumeratorsAreVisitedInTheirOrder) {
  std::vector<Season> seen;
  for (const Season season : enumerators<Season>) seen.push_back(season);
  EXPECT_EQ(seen, (std::vector{spring, summer, autumn, winter}));
}

TEST(EnumSet, HoldsWhatWasInsertedAndNotErased) {
  Seasons set;
  EXPECT_TRUE(set.empty());
  set.insert(autumn);
  set.insert(spring);
  set.insert(autumn);
  EXPECT_EQ(set, (Seasons{spring, autumn}));
  EXPECT_EQ(set.size(), 2u);
  EXPECT_TRUE(set.contains(autumn));
  EXPECT_FALSE(set.contains(winter));
  set.erase(autumn);
  set.erase(winter);
  EXPECT_EQ(set, Seasons{spring});
}

TEST(EnumSet, MembersAreVisitedInTheOrderOfTheEnumerators) {
  const Seasons set{winter, spring, summer};
  EXPECT_EQ(std::vector<Season>(set.begin(), set.end()), (std::vector{spring, summer, winter}));
  const Seasons none;
  EXPECT_EQ(none.begin(), none.end());
}

TEST(EnumSet, UnionIntersectionAndSubset) {
  const Seasons warm{spring, summer}, equinoxes{spring, autumn};
  EXPECT_EQ(warm | equinoxes, (Seasons{spring, summer, autumn}));
  EXPECT_EQ(warm & equinoxes, Seasons{spring});
  EXPECT_TRUE(warm.contains_all(Seasons{summer}));
  EXPECT_TRUE(warm.contains_all({}));
  EXPECT_FALSE(warm.contains_all(equinoxes));
  Seasons all = warm;
  all |= equinoxes;
  all &= {autumn, winter};
  EXPECT_EQ(all, Seasons{autumn});
}

TEST(EnumSet, EverySetIsMadeAgainFromItsBits) {
  for (unsigned bits = 0; bits < 16; ++bits) {
    const auto set = Seasons::from_bits(static_cast<std::uint8_t>(bits));
    EXPECT_EQ(set.bits(), bits);
    Seasons again;
    for (const Season season : set) again.insert(season);
    EXPECT_EQ(again, set);
  }
}

TEST(Bits, EachBitOfAWordOfAnyWidth) {
  for (std::size_t i = 0; i < 64; ++i) {
    const auto word = one_bit<std::uint64_t>(i);
    EXPECT_EQ(word, std::uint64_t{1} << i);
    for (std::size_t k = 0; k < 64; ++k) EXPECT_EQ(has_bit(word, k), i == k);
    EXPECT_EQ(first_bit(word), i);
    EXPECT_EQ(bit_if<std::uint64_t>(true, i), word);
    EXPECT_EQ(bit_if<std::uint64_t>(false, i), 0u);
  }
  EXPECT_EQ(one_bit<std::uint8_t>(winter), 8);
  EXPECT_TRUE(has_bit(std::uint8_t{0x80}, 7));
  EXPECT_EQ(first_bit(std::uint16_t{0}), 16u);
}

TEST(Bits, AreVisitedTheLowestFirst) {
  std::vector<std::size_t> seen;
  for_each_bit(0x8000'0000'0001'0005u, [&](std::size_t i) { seen.push_back(i); });
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 2, 16, 63}));
}

}  // namespace
}  // namespace axiscert
