// Swept parameters: what becomes of a query, in which words values are given, and that an address makes it again.
#include "fuzz/queries/sweep.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::AllOf, testing::HasSubstr;

std::string refusal(std::string_view text) {
  try {
    parse_sweep(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "taken";
}

TEST(Sweep, ValuesArePowersOfTwoOrNumbers) {
  const Sweep powers = parse_sweep("offset=2^0..2^20");
  ASSERT_EQ(powers.points.size(), 21u);
  EXPECT_EQ(powers.points.back().value, 0x1p20);
  EXPECT_EQ(powers.points.back().name(), "offset=2^20");
  const Sweep listed = parse_sweep("size=0.5,1,2^3");
  ASSERT_EQ(listed.points.size(), 3u);
  EXPECT_EQ(listed.parameter, SweepParameter::size);
  EXPECT_EQ(listed.points[2].value, 8);
  EXPECT_EQ(parse_sweep("offset=0,-2^4").points[1].value, -16);
}

TEST(Sweep, WhatIsWrongIsSaid) {
  EXPECT_THAT(refusal("ofset=1"), AllOf(HasSubstr("'ofset'"), HasSubstr("did you mean 'offset'")));
  EXPECT_THAT(refusal("offset"), HasSubstr("PARAMETER=VALUES"));
  EXPECT_THAT(refusal("offset="), HasSubstr("'' is not a number"));
  EXPECT_THAT(refusal("offset=1..10"), AllOf(HasSubstr("1..10"), HasSubstr("2^A..2^B")));
  EXPECT_THAT(refusal("offset=2^5..2^2"), AllOf(HasSubstr("empty"), HasSubstr("2^2..2^5")));
  EXPECT_THAT(refusal("offset=1,two"), HasSubstr("'two' is not a number"));
  EXPECT_THAT(refusal("size=0"), HasSubstr("above 0"));
  EXPECT_THAT(refusal("radius=-1"), HasSubstr("not negative"));
  EXPECT_THAT(refusal("size=1,2^0"), HasSubstr("same value"));
  EXPECT_NO_THROW(require_within(parse_sweep("offset=2^127"), Precision::binary32));
  EXPECT_THROW(require_within(parse_sweep("offset=2^128"), Precision::binary32), Error);
  EXPECT_NO_THROW(require_within(parse_sweep("offset=2^128"), Precision::binary64));
}

template <class Real>
void expect_same(const Vec3<Real>& found, const Vec3<Real>& expected) {
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.y, expected.y);
  EXPECT_EQ(found.z, expected.z);
}

template <class Real>
void expect_moved(const char* text, const std::function<void(const Query<Real>& q, const Query<Real>& swept)>& check) {
  const SourcePtr base = family_source(find_family("general"));
  const SourcePtr swept = swept_source(base, parse_sweep(text).points.front());
  EXPECT_EQ(swept->name(), std::string("general ") + text);
  EXPECT_EQ(swept->address_name(), std::string("general+") + text);
  EXPECT_EQ(split_swept(swept->address_name()).first, "general");
  EXPECT_EQ(split_swept(swept->address_name()).second, *swept_point(*swept));
  QueryBatch<Real> batch(64, coordinate_count);
  swept->fill(3, 1000, 64, batch);
  for (std::uint64_t i = 0; i < 64; ++i) {
    const auto q = query_from(base->make<Real>(3, 1000 + i)), found = query_from(batch[i]);
    EXPECT_EQ(coordinates(found), coordinates(query_from(swept->make<Real>(3, 1000 + i)))) << "by position alone";
    check(q, found);
  }
}

TEST(Sweep, AnOffsetMovesEveryPointAndRoundsIt) {
  expect_moved<float>("offset=2^8", [](const Query<float>& q, const Query<float>& swept) {
    EXPECT_EQ(swept.a.x, static_cast<float>(static_cast<double>(q.a.x) + 256));
    EXPECT_EQ(swept.c.z, static_cast<float>(static_cast<double>(q.c.z) + 256));
    EXPECT_EQ(swept.p.y, static_cast<float>(static_cast<double>(q.p.y) + 256));
    EXPECT_EQ(swept.r, q.r);
  });
}
TEST(Sweep, ASizeScalesAboutTheCentre) {
  expect_moved<double>("size=2^-3", [](const Query<double>& q, const Query<double>& swept) {
    expect_same(swept.p, q.p);
    EXPECT_EQ(swept.r, q.r / 8);
    EXPECT_NEAR(swept.b.x - q.p.x, (q.b.x - q.p.x) / 8, 1e-15);
  });
}
TEST(Sweep, ARadiusMultipliesTheRadiusAlone) {
  expect_moved<double>("radius=3", [](const Query<double>& q, const Query<double>& swept) {
    expect_same(swept.a, q.a);
    expect_same(swept.p, q.p);
    EXPECT_EQ(swept.r, 3 * q.r);
  });
}

TEST(Sweep, TheSizeOfScenesIsThatOfTheFamily) {
  const double size = median_scene_size(*family_source(find_family("general")), 1, Precision::binary64);
  EXPECT_GT(size, 0.5);
  EXPECT_LT(size, 2);
}

}  // namespace
}  // namespace axiscert
