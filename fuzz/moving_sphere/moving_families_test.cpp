// The families of the moving sphere: oracles that agree on every query, and families that make what they claim.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstdlib>

#include "exact/judge/oracles.h"
#include "exact/moving_sphere/first_contact.h"
#include "exact/moving_sphere/motion_distance.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert {

// Tests are listed with it; without it, with a pointer.
static void PrintTo(const Family* family, std::ostream* out) { *out << family->name; }

namespace {

template <class Real>
class MovingFamilies : public testing::Test {};
using MovingReals = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingFamilies, MovingReals);
// A test each family: each takes minutes.
class MovingFamiliesLong : public testing::TestWithParam<const Family*> {};
INSTANTIATE_TEST_SUITE_P(Each, MovingFamiliesLong, testing::ValuesIn(families_of(find_predicate("moving-sphere"))),
                         [](const auto& family) {
                           return std::string(family.param->name.substr(family.param->name.find('/') + 1));
                         });

template <class Real>
MovingQuery<double> widened_motion(const Numbers<Real>& numbers) {
  return MovingSphere::problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); });
}
template <class Real>
moving_sphere::GivenMotion motion_of(const Family& family, const Numbers<Real>& numbers) {
  if (family.entry == MovingSphere::entry) return widened_motion(numbers);
  return MovingEnds::problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); });
}

// The first time against verdicts of CGAL: the motion as far as the float below t* is not in contact before t*, and as
// far as the float after it is.
template <class Real>
testing::AssertionResult time_is_where_verdicts_change(const moving_sphere::GivenMotion& motion) {
  using moving_sphere::compare, moving_sphere::swept_distance_order;
  const auto contact = moving_sphere::first_contact(motion);
  if (!contact) return testing::AssertionFailure() << "no time beside a contact";
  const Real best = moving_sphere::rounded_down<Real>(contact->time);
  const int at_best = swept_distance_order(motion, static_cast<double>(best));
  if ((at_best <= 0) != (compare(contact->time, exact(best)) == 0))
    return testing::AssertionFailure() << "as far as " << best << " CGAL's order is " << at_best;
  const Real next = std::nextafter(best, Real(2));
  if (next <= 1 && swept_distance_order(motion, static_cast<double>(next)) > 0)
    return testing::AssertionFailure() << "no contact as far as " << next;
  return testing::AssertionSuccess();
}

struct MovingCounts {
  std::uint64_t queries = 0, contacts = 0, touching = 0, invalid = 0;
};

// The truth of the first queries at seed 1, which throws where oracles disagree, and their times.
template <class Real>
MovingCounts counted(std::string_view name, std::uint64_t queries) {
  const Family& family = find_family(name);
  const Oracles& oracles = oracles_of(moving_sphere_predicate(), family.entry);
  MovingCounts found;
  // In a family of images, each image of one base after the other.
  const ImageGroup* group = image_group(name);
  const std::uint64_t stride = group ? group->size + 1 : 1;
  for (std::uint64_t i = 0; i < queries; ++i) {
    const Numbers<Real> numbers = family.make<Real>(1, i * stride);
    const Truth truth = oracles.truth(numbers);
    ++found.queries;
    found.contacts += truth.verdict == Verdict::contact;
    if (truth.verdict == Verdict::contact) {
      EXPECT_TRUE(time_is_where_verdicts_change<Real>(motion_of(family, numbers))) << name << ", query " << i * stride;
    }
    found.touching += truth.touching;
    found.invalid += truth.verdict == Verdict::invalid;
  }
  return found;
}

template <class Real>
void expect_agreement(const Family& family, std::uint64_t queries) {
  MovingCounts found;
  ASSERT_NO_THROW(found = counted<Real>(family.name, queries)) << family.name << ", seed 1";
  EXPECT_EQ(found.invalid, 0u) << family.name;
  EXPECT_GT(found.contacts, queries / 50) << family.name;
  EXPECT_LT(found.contacts, queries) << family.name << " never misses";
}

TYPED_TEST(MovingFamilies, AreAgreedUponByTheOracles) {
  for (const Family* family : families_of(moving_sphere_predicate())) expect_agreement<TypeParam>(*family, 200);
}
// AXISCERT_QUERIES=1000000 in the environment asks as many of each family, which takes five minutes a family. Divided
// twice in slow builds: sanitized, exact numbers on the heap take most of an hour for a twentieth of a million.
TEST_P(MovingFamiliesLong, AreAgreedUponByTheOraclesOnManyQueriesInEachPrecision) {
  const char* const asked = std::getenv("AXISCERT_QUERIES");
  const std::uint64_t many = asked ? std::strtoull(asked, nullptr, 10) : 100000,
                      queries = many / (TRIAL_DIVISOR * TRIAL_DIVISOR);
  ASSERT_GE(queries, 200u) << "AXISCERT_QUERIES is " << (asked ? asked : "not set");
  expect_agreement<float>(*GetParam(), queries);
  expect_agreement<double>(*GetParam(), queries);
}

// A motion by its ends is that of the family it is made of, of the same stream, where P + D is a number.
TYPED_TEST(MovingFamilies, OfEndsAreMotionsFromPToP1) {
  const Family &ends = find_family("moving-sphere/ends_lattice"), &whole = find_family("moving-sphere/ends_approach");
  EXPECT_EQ(ends.entry, MovingEnds::entry);
  int inexact = 0;
  for (std::uint64_t position = 0; position < 200; ++position) {
    const Numbers<TypeParam> q = ends.make<TypeParam>(1, position);
    for (std::size_t k = 12; k < 15; ++k) EXPECT_EQ(q[k], std::trunc(q[k])) << position;
    const Numbers<TypeParam> far = whole.make<TypeParam>(1, position);
    for (std::size_t k = 12; k < 15; ++k) {
      const Rational difference = exact(far[k]) - exact(far[k - 3]);
      inexact += difference != exact(far[k] - far[k - 3]);
    }
  }
  EXPECT_GT(inexact, 100) << "of 600 coordinates of D that are no numbers of the precision";
}

// Every other time they touch exactly, and the other times are within ulps of it.
TYPED_TEST(MovingFamilies, OfTouchingTouchExactly) {
  for (const char* name :
       {"graze", "touch_end", "touch_start", "along_edge", "ends_graze", "ends_touch", "ends_along"}) {
    const MovingCounts found = counted<TypeParam>(fmt::format("moving-sphere/{}", name), 240);
    EXPECT_GE(found.touching, found.queries / 2) << name;
    EXPECT_LT(found.touching, found.queries) << name;
  }
}

// D = k d would first touch at s / k, for whole k up to 8 and s up to k + 1: every other time exactly.
TYPED_TEST(MovingFamilies, OfExactTimesTouchAtAnEighthOrSuch) {
  const Family& family = find_family("moving-sphere/exact_time");
  int exact_times = 0;
  for (std::uint64_t position = 0; position < 120; ++position) {
    const MovingQuery<double> q = widened_motion(family.make<TypeParam>(1, position));
    const auto contact = moving_sphere::first_contact(q);
    if (!contact) continue;
    for (int k = 2; k <= 8; ++k) {
      for (int s = 1; s <= k; ++s) {
        if (moving_sphere::compare(contact->time, Rational(s, k)) != 0) continue;
        ++exact_times;
        s = k = 9;
      }
    }
  }
  EXPECT_GE(exact_times, 40);
}

// The scenes are of metres: spheres of 0.1 to 1 m, bullets below 1 cm, and motions of a frame.
TYPED_TEST(MovingFamilies, OfScenesAreOfAFrame) {
  struct ExpectedScene {
    const char* name;
    double least_radius, greatest_radius, least_step, greatest_step;
  };
  // A place 1 km away is rounded to 2^-14 m in binary32.
  const double slack = sizeof(TypeParam) == 4 ? 0x1p-12 : 0x1p-40;
  for (const ExpectedScene& expected : {ExpectedScene{"walk", 0.1, 1, 0.008, 0.14},
                                        {"fall", 0.1, 1, 0.01, 2},
                                        {"bullet", 0, 0.01, 1, 17.01},
                                        {"shake", 0.1, 1, 0, 1.01e-3}}) {
    const Family& family = find_family(fmt::format("moving-sphere/scene_{}", expected.name));
    for (std::uint64_t position = 0; position < 300; ++position) {
      const MovingQuery<double> q = widened_motion(family.make<TypeParam>(1, position));
      const double step = std::sqrt(portable::dot(q.d, q.d));
      EXPECT_TRUE(q.r >= expected.least_radius - 1e-7 && q.r <= expected.greatest_radius) << family.name << position;
      EXPECT_TRUE(step >= expected.least_step - slack && step <= expected.greatest_step + slack)
          << family.name << " at " << position << ": " << step;
    }
  }
}

// Clear of touching in every unit of length, from the subnormals to the end of the range.
TYPED_TEST(MovingFamilies, OfScaleAreClear) {
  const Family& family = find_family("moving-sphere/scale");
  using Limits = std::numeric_limits<TypeParam>;
  constexpr auto powers = static_cast<std::uint64_t>(Limits::max_exponent - Limits::min_exponent + Limits::digits);
  TypeParam least = Limits::max(), greatest = 0;
  for (std::uint64_t position = 0; position < powers; ++position) {
    const Numbers<TypeParam> q = family.make<TypeParam>(1, position);
    for (const TypeParam x : q) {
      ASSERT_TRUE(std::isfinite(x)) << position;
      greatest = std::max(greatest, std::abs(x));
      if (x != 0) least = std::min(least, std::abs(x));
    }
    // In the subnormals each number is rounded, and so is a radius far below the others.
    if (position < 3 * static_cast<std::uint64_t>(Limits::digits) || position % 7 != 0) continue;
    const Rational square = moving_sphere::least_distance(widened_motion(q)).squared, r(static_cast<double>(q[15]));
    const Rational rr(r * r);
    EXPECT_TRUE(rr * 39 / 10 <= square || rr * 10 >= square * 39) << position;
    EXPECT_GT(rr + square, 0) << position;
  }
  EXPECT_EQ(least, Limits::denorm_min());
  EXPECT_GE(greatest, std::ldexp(TypeParam(1), Limits::max_exponent - 2));
}

TYPED_TEST(MovingFamilies, OfNoMotionAreTheStaticQuery) {
  const Family& family = find_family("moving-sphere/zero_d");
  for (std::uint64_t position = 0; position < 100; ++position) {
    const Numbers<TypeParam> q = family.make<TypeParam>(1, position);
    EXPECT_TRUE(q[12] == 0 && q[13] == 0 && q[14] == 0) << position;
  }
}

TYPED_TEST(MovingFamilies, RoundNothingWhereTheySaySo) {
  for (const Family* family : families_of(moving_sphere_predicate())) {
    if (!family->exact_arithmetic) continue;
    for (std::uint64_t position = 0; position < 2000; ++position) {
      const Numbers<TypeParam> numbers = family->make<TypeParam>(1, position);
      const auto load = [&](std::size_t k) { return numbers[k]; };
      const auto ignore = [](std::size_t, TypeParam, TypeParam) {};
      std::feclearexcept(FE_INEXACT);
      if (family->entry == MovingSphere::entry)
        bits_of<moving_sphere::Twenty, TypeParam>(MovingSphere::problem<TypeParam>(load), ignore);
      else bits_of<moving_sphere::Twenty, TypeParam>(MovingEnds::problem<TypeParam>(load), ignore);
      ASSERT_EQ(std::fetestexcept(FE_INEXACT), 0) << family->name << " at " << position;
    }
  }
}

// In turn each of the twenty axes as the only one that separates, but every fourth round, which is in contact. Of
// integers up to 3 the axes of vertices at the end are hard to find.
TYPED_TEST(MovingFamilies, OfOneAxisAreSeparatedByItAlone) {
  const Family& family = find_family("moving-sphere/one_axis");
  const Predicate& predicate = moving_sphere_predicate();
  const Oracles& oracles = oracles_of(predicate);
  const std::size_t axes = predicate.clauses.size();
  std::vector<int> alone(axes);
  for (std::uint64_t position = 0; position < 80 * axes; ++position) {
    const Numbers<TypeParam> q = family.make<TypeParam>(1, position);
    const Verdict verdict = oracles.truth(q).verdict;
    if (position / axes % 4 == 3) {
      EXPECT_EQ(verdict, Verdict::contact) << position;
      continue;
    }
    EXPECT_EQ(verdict, Verdict::separated) << position;
    const auto bits = bits_of<moving_sphere::TwentyNonstrict, TypeParam>(
        MovingSphere::problem<TypeParam>([&](std::size_t k) { return q[k]; }),
        [](std::size_t, TypeParam, TypeParam) {});
    alone[position % axes] += clauses_of(predicate, bits) == one_bit<ClauseBits>(position % axes);
  }
  for (std::size_t axis = 0; axis < axes; ++axis) {
    EXPECT_GE(alone[axis], sizeof(TypeParam) == 4 ? 5 : 50) << predicate.clauses[axis].name << ", of 60";
  }
}

// Thirteen regions: the vertices, the edges in the middle and near either end, the face.
constexpr std::size_t region_count = 13;
moving_sphere::Feature feature_of_region(std::size_t region) {
  using moving_sphere::Feature;
  if (region == region_count - 1) return Feature::face;
  return static_cast<Feature>(region < 3 ? region : 3 + region % 3);
}

// Every other round arrives, first at the feature in turn; the others stop short of it.
TYPED_TEST(MovingFamilies, OfReachArriveFirstAtEachFeatureInTurn) {
  const Family& family = find_family("moving-sphere/reach");
  std::size_t elsewhere = 0;
  const std::uint64_t queries = 20 * region_count;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const auto contact = moving_sphere::first_contact(motion_of(family, family.make<TypeParam>(1, position)));
    ASSERT_EQ(contact.has_value(), position / region_count % 2 == 0) << position;
    if (contact) elsewhere += !contact->features.contains(feature_of_region(position % region_count));
  }
  EXPECT_EQ(elsewhere, 0u) << "of " << queries;
}

// What each clear family means to make, and its verdicts; an eighth or more of them are clear.
TYPED_TEST(MovingFamilies, OfClearMotionsHaveTheVerdictThatTheyMean) {
  const auto expect = [](const char* name, const auto& is_contact) {
    const Family& family = find_family(std::string("moving-sphere/") + name);
    const Oracles& oracles = oracles_of(moving_sphere_predicate(), family.entry);
    std::uint64_t clear = 0, wrong = 0;
    const std::uint64_t queries = 400;
    for (std::uint64_t position = 0; position < queries; ++position) {
      const std::optional<Verdict> verdict = oracles.clear_verdict(family.make<TypeParam>(1, position));
      if (!verdict) continue;
      ++clear;
      wrong += (*verdict == Verdict::contact) != is_contact(position);
    }
    EXPECT_EQ(wrong, 0u) << name << ", of " << clear << " clear";
    EXPECT_GT(clear, queries / 8) << name;
  };
  const auto every_other_of = [](std::uint64_t regions) {
    return [regions](std::uint64_t position) { return position / regions % 2 == 0; };
  };
  for (const char* name : {"reach", "far_past", "moves", "ends_reach", "ends_far_past"})
    expect(name, every_other_of(13));
  for (const char* name : {"starts", "ends_starts"}) {
    expect(name, [](std::uint64_t position) { return position / region_count % 5 % 2 == 0; });
  }
  for (const char* name : {"alongside", "ends_alongside"}) expect(name, every_other_of(14));
  expect("edge_ends", every_other_of(9));
}

// A clear verdict that a small change of the query turns into the other, exactly: that of a kernel which takes the one
// for the other.
template <class Real, class Change>
std::uint64_t turned_by(const char* name, const Change& change) {
  const Family& family = find_family(name);
  const Oracles& oracles = oracles_of(moving_sphere_predicate());
  std::uint64_t turned = 0;
  for (std::uint64_t position = 0; position < 2000; ++position) {
    const Numbers<Real> numbers = family.make<Real>(1, position);
    const std::optional<Verdict> clear = oracles.clear_verdict(numbers);
    if (!clear) continue;
    MovingQuery<double> q = widened_motion(numbers);
    change(q);
    turned += oracles.truth(Numbers<double>(q)).verdict != *clear;
  }
  return turned;
}
TYPED_TEST(MovingFamilies, OfClearMotionsAreDecidedByLittle) {
  using portable::Vec3;
  const auto length = [](const Vec3<double>& v) { return std::sqrt(dot(v, v)); };
  const auto goes_too_far = [](MovingQuery<double>& q) { q.d = q.d * 1.0001; };
  const auto has_a_skin = [](MovingQuery<double>& q) { q.r *= 1.0001; };
  const auto stands_still = [&](MovingQuery<double>& q) {
    if (length(q.d) < 0.01 * q.r) q.d = {0, 0, 0};
  };
  const auto is_parallel = [&](MovingQuery<double>& q) {
    const Vec3<double> normal = cross(q.b - q.a, q.c - q.a), unit = normal * (1 / length(normal));
    const double down = dot(q.d, unit);
    if (std::fabs(down) < 0.01 * length(q.d)) q.d = q.d - unit * down;
  };
  // Edges and face, a 500th longer about their middle.
  const auto is_wider = [](MovingQuery<double>& q) {
    const Vec3<double> middle = (q.a + q.b + q.c) * (1.0 / 3);
    for (Vec3<double>* corner : {&q.a, &q.b, &q.c}) *corner = *corner + (*corner - middle) * 0.002;
  };
  EXPECT_GT(turned_by<TypeParam>("moving-sphere/reach", goes_too_far), 5u);
  EXPECT_GT(turned_by<TypeParam>("moving-sphere/reach", has_a_skin), 5u);
  EXPECT_GT(turned_by<TypeParam>("moving-sphere/moves", stands_still), 50u);
  EXPECT_GT(turned_by<TypeParam>("moving-sphere/alongside", is_parallel), 20u);
  EXPECT_GT(turned_by<TypeParam>("moving-sphere/edge_ends", is_wider), 50u);
}

// Neither end of the path is in contact, and the path with none of the edges.
TYPED_TEST(MovingFamilies, OfUnitsEveryFourthBaseIsDecidedByTheFaceAlone) {
  const Family& family = find_family("moving-sphere/units");
  const std::size_t images = image_group(family.name)->size;
  const auto is_contact = [](const MovingQuery<double>& q) {
    return oracles_of(moving_sphere_predicate()).truth(Numbers<double>(q)).verdict == Verdict::contact;
  };
  std::size_t alone = 0;
  for (std::uint64_t base = 3; base < 240; base += 4) {
    const MovingQuery<double> q = widened_motion(family.make<TypeParam>(1, base * images));
    MovingQuery<double> start = q, end = q;
    end.p = end.p + end.d;
    start.d = end.d = {0, 0, 0};
    MovingQuery<double> ab = q, bc = q, ca = q;
    ab.c = ab.b;
    bc.a = bc.c;
    ca.b = ca.a;
    const bool elsewhere = is_contact(start) || is_contact(end) || is_contact(ab) || is_contact(bc) || is_contact(ca);
    alone += is_contact(q) && !elsewhere;
  }
  EXPECT_GE(alone, 55u) << "of 60";
}

// The verdicts of the kernels on the lattice, where nothing is rounded: only the theorem is left.
TEST(MovingSphereKernels, WhereNothingIsRoundedTheNonstrictAreRightAndTheStrictInventContacts) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel("moving-sphere/twenty"), &find_kernel("moving-sphere/twenty-nonstrict")};
  plan.questions.sources = {family_source(find_family("moving-sphere/lattice"))};
  plan.questions.precisions = {Precision::binary64};
  plan.questions.trials = [](const Source&, Precision) { return std::uint64_t{3000}; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  const CampaignResult result = run_campaign(plan, never, [](const Progress&) {});
  ASSERT_EQ(result.cells.size(), 1u);
  EXPECT_EQ(result.cells[0].queries, 3000u);
  const std::vector<Tally>& tallies = result.cells[0].tallies;
  for (const Tally& tally : tallies) {
    EXPECT_EQ(tally.verdict.false_separation, 0u) << "over the reals none of the axes separates wrongly";
  }
  EXPECT_GT(tallies[0].verdict.false_contact, 10u);
  EXPECT_EQ(tallies[1].verdict.false_contact, 0u);
}

// Planted by its method: a zero area gives the plane's normal as 0/0, and D = 0 each time.
TEST(MovingSphereKernels, TheRoundedFormMissesContactsOfZeroArea) {
  const Implementation<double> rounded = find_kernel("moving-sphere/rounded").on<double>(scalar_target);
  const Implementation<double> twenty = find_kernel("moving-sphere/twenty-nonstrict").on<double>(scalar_target);
  const Numbers<double> inside_a_segment =
      MovingQuery<double>{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 1, 0}, 1};
  EXPECT_EQ(oracles_of(moving_sphere_predicate()).truth(inside_a_segment).verdict, Verdict::contact);
  EXPECT_EQ(ask(twenty, inside_a_segment).verdicts[0], Verdict::contact);
  EXPECT_EQ(ask(rounded, inside_a_segment).verdicts[0], Verdict::separated);
  const Numbers<double> ahead = MovingQuery<double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {0, 0, -3}, 1};
  EXPECT_EQ(ask(rounded, ahead).verdicts[0], Verdict::contact);
}

// Wrong answers of a kernel to contacts and to separations, of as many queries of a family.
std::pair<int, int> missed_and_invented(const char* kernel, const char* family, std::uint64_t queries) {
  const Implementation<double> implementation = find_kernel(kernel).on<double>(scalar_target);
  int missed = 0, invented = 0;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<double> q = find_family(family).make<double>(1, position);
    const Verdict truth = oracles_of(moving_sphere_predicate()).truth(q).verdict,
                  said = ask(implementation, q).verdicts[0];
    missed += said == Verdict::separated && truth == Verdict::contact;
    invented += said == Verdict::contact && truth == Verdict::separated;
  }
  return {missed, invented};
}

TEST(MovingSphereKernels, OtherFormsAreRightOnOrdinaryMotionsAndAdvancingByLengthComesTooLate) {
  const std::pair<int, int> none{0, 0};
  for (const char* kernel : {"moving-sphere/rounded", "moving-sphere/segment", "moving-sphere/advance"}) {
    EXPECT_EQ(missed_and_invented(kernel, "moving-sphere/general", 1500), none) << kernel;
  }
  const auto [missed, invented] = missed_and_invented("moving-sphere/advance-by-length", "moving-sphere/general", 1500);
  EXPECT_GT(missed, 10);
  EXPECT_EQ(invented, 0);
}

}  // namespace
}  // namespace axiscert
