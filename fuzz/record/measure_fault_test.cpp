// What is wrong with the numbers beside a contact, by its kind and size.
#include "fuzz/record/measure_fault.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace axiscert {
namespace {

TEST(MeasureFault, EachIsOfItsMeasureAndHasItsSize) {
  ContactJudgement judgement;
  for (const MeasureFault which : enumerators<MeasureFault>)
    EXPECT_FALSE(measure_error(judgement, which)) << name(which);
  judgement.time = TimeVerdict::none;
  EXPECT_EQ(measure_error(judgement, MeasureFault::no_time)->text, "a contact without a time");
  judgement.time = TimeVerdict::invalid;
  EXPECT_EQ(measure_error(judgement, MeasureFault::no_time)->text, "a time outside [0, 1]");
  judgement.time = TimeVerdict::late;
  EXPECT_FALSE(measure_error(judgement, MeasureFault::no_time) || measure_error(judgement, MeasureFault::early_time));
  EXPECT_TRUE(measure_error(judgement, MeasureFault::late_time));
  judgement.ulps = round_up(Rational(1000000));
  judgement.share = 0.125;
  judgement.length = 1.5;
  EXPECT_EQ(measure_error(judgement, MeasureFault::late_time)->text, "late by 12.5 % of the way, length 1.5");
  judgement.feature_is_right = true;
  EXPECT_FALSE(measure_error(judgement, MeasureFault::feature));
  judgement.feature_is_right = false;
  judgement.feature_error = 0.25;
  EXPECT_EQ(measure_error(judgement, MeasureFault::feature)->size, 0.25);
  judgement.feature_error = std::numeric_limits<double>::infinity();
  EXPECT_EQ(measure_error(judgement, MeasureFault::feature)->text, "a feature that there is not");
  judgement.normal_angle = judgement.normal_length_error = judgement.point_error = 0;
  EXPECT_FALSE(measure_error(judgement, MeasureFault::normal) || measure_error(judgement, MeasureFault::point));
  judgement.normal_angle = 0.5;
  judgement.normal_length_error = 0.125;
  judgement.point_error = 2;
  EXPECT_EQ(measure_error(judgement, MeasureFault::normal)->text, "off by 0.5 radians");
  EXPECT_EQ(measure_error(judgement, MeasureFault::length)->size, 0.125);
  EXPECT_EQ(measure_error(judgement, MeasureFault::point)->text, "off by 2 of the scene");
  EXPECT_EQ(measure_of(MeasureFault::length), MeasureKind::normal);
  EXPECT_EQ(measure_of(MeasureFault::early_time), MeasureKind::time);
}

TEST(MeasureFault, PointsAreOfAPredicateThatHasTwo) {
  EXPECT_THAT(fault_words(find_predicate("sphere-triangle")), testing::Not(testing::Contains("points")));
  EXPECT_THAT(fault_words(find_predicate("box-box")), testing::Contains("points"));
}

}  // namespace
}  // namespace axiscert
