// The feedback of the kernel target: the bucket of a margin, and that no two cases share a counter.
#include "fuzz/targets/margin_bucket.h"

#include <gtest/gtest.h>

#include <set>

namespace axiscert::fuzzing {
namespace {

TEST(MarginBucket, IsTheExponentOfTheScaleBesideThatOfTheMargin) {
  EXPECT_EQ(margin_bucket(BinaryNumber(1), BinaryNumber()), 0u);
  EXPECT_EQ(margin_bucket(BinaryNumber(3), BinaryNumber(1)), 1u);             // 4 beside 2
  EXPECT_EQ(margin_bucket(BinaryNumber(1), BinaryNumber(1 - 0x1p-24)), 24u);  // 2 - 2^-24 beside 2^-24
  EXPECT_EQ(margin_bucket(BinaryNumber(1 - 0x1p-53), BinaryNumber(1)), 53u);
  EXPECT_EQ(margin_bucket(BinaryNumber(0x1p-1074), BinaryNumber()), 0u) << "free of units";
}

TEST(MarginBucket, HasOneForTiesAndOneForAllThatIsBeyond) {
  EXPECT_EQ(margin_bucket(BinaryNumber(5), BinaryNumber(5)), tie_bucket);
  EXPECT_EQ(margin_bucket(BinaryNumber(), BinaryNumber()), tie_bucket);
  EXPECT_EQ(margin_bucket(BinaryNumber(1), BinaryNumber(1) + BinaryNumber(0x1p-1000)), most_bucket);
}

TEST(MarginCounter, IsAnotherOneForEachCase) {
  std::set<std::size_t> counters;
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    for (std::size_t i = 0; i < comparison_count; ++i) {
      for (std::size_t kind = 0; kind < sign_kind_count; ++kind) {
        for (const auto& [lhs, rhs] : {std::pair(2, 1), std::pair(1, 2), std::pair(1, 1), std::pair(9, 8)}) {
          const std::size_t counter = margin_counter(precision, static_cast<Comparison>(i), BinaryNumber(lhs),
                                                     BinaryNumber(rhs), static_cast<SignKind>(kind));
          ASSERT_LT(counter, margin_counter_count);
          EXPECT_TRUE(counters.insert(counter).second) << i << ", kind " << kind << ": " << lhs << " > " << rhs;
        }
      }
    }
  }
}

}  // namespace
}  // namespace axiscert::fuzzing
