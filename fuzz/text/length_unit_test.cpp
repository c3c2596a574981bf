// Lengths with a unit: read, and printed in the unit that leaves three digits.
#include <gtest/gtest.h>

#include "fuzz/text/length_unit.h"

namespace axiscert {
namespace {

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
