// The words of what is said beside verdicts, from counts.
#include "reports/instrument/league_contacts.h"

#include <gtest/gtest.h>

#include <numbers>

namespace axiscert {
namespace {

// A tally in which 100 answers have every number, and nothing is wrong.
ContactTally all_right() {
  ContactTally tally;
  tally.answers = tally.separation->judged = tally.feature->judged = tally.normal->judged = tally.pushed->judged =
      tally.point->judged = 100;
  return tally;
}

TEST(LeagueContacts, SayThatANumberIsNotGiven) {
  for (const ContactTally& none : {ContactTally(), given_contacts(all_right(), sphere_triangle_predicate(), 0)}) {
    EXPECT_EQ(separation_words(none, none), "not given");
    EXPECT_EQ(contradiction_words(none), "-");
    EXPECT_EQ(flip_words(none), "not given");
    EXPECT_EQ(normal_words(none, none), "not given");
    EXPECT_EQ(feature_words(none), "not given");
    EXPECT_EQ(point_words(none, none), "not given");
  }
}

TEST(LeagueContacts, SayHowFarASeparationIsOffInMetresAndOfTheScene) {
  ContactTally all = all_right();
  EXPECT_EQ(separation_words(all, ContactTally()), "the nearest numbers on all 100");
  all.separation->largest_error.offer({0.25, 3});
  all.separation->largest_length.offer({1e6, 3});
  EXPECT_EQ(separation_words(all, ContactTally()), "off by up to 0.25 of the scene") << "no scene was asked";
  ContactTally scenes = all_right();
  scenes.separation->largest_length.offer({0.0123, 4});
  EXPECT_EQ(separation_words(all, scenes), "off by up to 1.23 cm on scenes, 0.25 of the scene");
  all.separation->none = 7;
  EXPECT_EQ(separation_words(all, scenes), "off by up to 1.23 cm on scenes, 0.25 of the scene; none beside 7");
}

TEST(LeagueContacts, CountContradictionsFlipsAndFeatures) {
  ContactTally all = all_right();
  EXPECT_EQ(contradiction_words(all), "none");
  EXPECT_EQ(flip_words(all), "none of 100; a push leaves up to 0 of the depth");
  EXPECT_EQ(feature_words(all), "none of 100 wrong");
  all.consistency->positive = 1200;
  all.consistency->missing = 3;
  all.pushed->flips = 12;
  all.pushed->largest_left.offer({round_up(Rational(2)), 5});
  all.feature->wrong = 4;
  EXPECT_EQ(contradiction_words(all),
            "1,200 contacts with a separation above 0; 3 answers without one of their numbers");
  EXPECT_EQ(flip_words(all), "12 of 100; a push leaves up to 2 of the depth");
  EXPECT_EQ(feature_words(all), "4 of 100 wrong");
}

TEST(LeagueContacts, SayHowFarNormalsAreTiltedAndPointsAreOff) {
  ContactTally all = all_right(), scenes = all_right();
  all.normal->largest_angle.offer({std::numbers::pi, 1});
  all.normal->largest_length_error.offer({0.5, 1});
  scenes.normal->largest_angle.offer({std::numbers::pi / 180, 2});
  EXPECT_EQ(normal_words(all, ContactTally()), "tilted by up to 180 degrees, length off by up to 0.5");
  EXPECT_EQ(normal_words(all, scenes), "tilted by up to 1 degrees on scenes, 180 at most, length off by up to 0.5");
  all.point->largest_error.offer({0.5, 1});
  EXPECT_EQ(point_words(all, scenes), "off by up to 0 of the scene on scenes, 0.5 at most");
}

}  // namespace
}  // namespace axiscert
