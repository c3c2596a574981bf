// The row of a kernel's first contacts: numbers as a record has them, and dashes for what the kernel does not give.
#include "reports/wording/motion.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiscert {
namespace {

using testing::ElementsAre;

Json tunnels(double deepest) { return {{"through", deepest == 1 ? 2 : 0}, {"deepest_tunnel", deepest}}; }
Json time_errors(const Json& ulps, double in_u) {
  return {{"largest_ulps", ulps}, {"largest_in_u", in_u}, {"by_power", Json::object()}};
}

Json family_of(Json time, double missed) {
  return {{"motion",
           {{"hits", 1200},
            {"missed", tunnels(missed)},
            {"time", std::move(time)},
            {"feature", nullptr},
            {"normal", {{"judged", 7}, {"largest_angle", 0.25}}},
            {"point", nullptr}}}};
}

TEST(MotionWords, ARowHasACellForEachColumn) {
  const Json time = {{"none", 1},
                     {"invalid", 2},
                     {"early", 30},
                     {"best", 1100},
                     {"late", 67},
                     {"late_errors", time_errors("1.5e+320", 8)},
                     {"late_tunnels", tunnels(0.5)},
                     {"early_errors", time_errors(3.5, 0.125)},
                     {"largest_gap", 0.0}};
  const auto cells = motion_cells(family_of(time, 1));
  EXPECT_EQ(cells.size(), motion_columns().size());
  EXPECT_THAT(
      cells, ElementsAre("1,200", "67", "1.5e+320", "8", "0.5", "30", "3.5", "0.125", "3", "-", "0.25", "-", "2", "1"));
}

TEST(MotionWords, AKernelWithoutTimesHasARowWhereItMisses) {
  EXPECT_TRUE(motion_cells(family_of(nullptr, 0)).empty());
  EXPECT_THAT(motion_cells(family_of(nullptr, 0.75)),
              ElementsAre("1,200", "-", "-", "-", "-", "-", "-", "-", "-", "-", "0.25", "-", "0", "0.75"));
  EXPECT_TRUE(motion_cells(Json::object()).empty()) << "a test without measures";
}

}  // namespace
}  // namespace axiscert
