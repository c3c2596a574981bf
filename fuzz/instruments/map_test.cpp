// Maps: each pixel has the query that its position says, and the class that `check` gives for that query.
#include "fuzz/instruments/map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/judge/examine.h"
#include "exact/judge/oracles.h"
#include "exact/numbers/rational.h"
#include "fuzz/instruments/instruments_testing.h"
#include "fuzz/queries/family.h"
#include "kernel/ask.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t seed = 31;

template <class Real>
class Maps : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Maps, Reals);

template <class Real>
StoredQuery stored(const Query<Real>& q) {
  return {"q", precision_of<Real>, q, &sphere_triangle_predicate()};
}

MovedNumbers numbers_named(std::string_view name) {
  return parse_numbers(name, sphere_triangle_predicate().entries.front());
}
template <class Real>
Query<Real> query_at(const Plane& plane, const Query<Real>& witness, std::size_t column, std::size_t row) {
  return query_from(axiscert::query_at(plane, Numbers<Real>(witness), column, row));
}
template <class Real>
Plane exponent_plane(const Query<Real>& witness, const MovedNumbers& along, const MovedNumbers& across,
                     std::size_t size) {
  return axiscert::exponent_plane(Numbers<Real>(witness), along, across, size);
}

// The number of steps of nextafter from one float to another, at most `most`.
template <class Real>
int steps_between(Real from, Real to, int most) {
  int n = 0;
  for (Real x = from; x != to && n <= most; ++n) x = std::nextafter(x, to);
  return from <= to ? n : -n;
}

TYPED_TEST(Maps, APixelIsSoManyUlpsFromTheWitness) {
  using Real = TypeParam;
  Query<Real> witness = find_family("tangent").make<Real>(seed, 3);
  witness.b.y = std::numeric_limits<Real>::denorm_min() * 3;  // the plane goes through zero
  const Plane plane = ulp_plane(numbers_named("b.y"), numbers_named("r"), 16, 2);
  expect_same_bits(query_at(plane, witness, plane.along.origin(), plane.rows() - 1 - plane.across.origin()), witness);
  for (std::size_t row = 0; row < plane.rows(); ++row) {
    for (std::size_t column = 0; column < plane.columns(); ++column) {
      Query<Real> q = query_at(plane, witness, column, row);
      ASSERT_EQ(steps_between(witness.b.y, q.b.y, 40), 2 * (static_cast<int>(column) - 8));
      ASSERT_EQ(steps_between(witness.r, q.r, 40), 2 * (7 - static_cast<int>(row)));
      q.b.y = witness.b.y;
      q.r = witness.r;
      expect_same_bits(q, witness);
    }
  }
}

TYPED_TEST(Maps, FarFromTheWitnessAreNoNumbersAndNoOthers) {
  using Real = TypeParam;
  constexpr Real most = std::numeric_limits<Real>::max();
  const Query<Real> witness = {{most, 0, 0}, {-most, 1, 0}, {0, 0, 1}, {0, 0, 0}, 0};
  const Plane plane = ulp_plane(numbers_named("a.x"), numbers_named("b.x"), greatest_map, greatest_ulps);
  for (const std::size_t pixel : {plane.along.origin() + 1, plane.columns() - 1}) {
    EXPECT_FALSE(std::isfinite(query_at(plane, witness, pixel, 0).a.x));
    EXPECT_FALSE(std::isfinite(query_at(plane, witness, 0, plane.rows() - 1 - (plane.across.origin() - 1)).b.x));
  }
  EXPECT_FALSE(std::isfinite(query_at(plane, witness, 0, plane.rows() - 1).b.x));
}

TYPED_TEST(Maps, ExponentsReachFromTheLeastSubnormalToTheGreatestBinade) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  const Query<Real> witness = {{1, 3, 0}, {-1, 0.5, 0}, {0, 0, -0.0}, {0, 0, 0}, 1.5};
  const Plane plane = exponent_plane(witness, numbers_named("triangle"), numbers_named("r"), greatest_map);
  const std::size_t all = Limits::max_exponent - Limits::min_exponent + Limits::digits;
  EXPECT_EQ(plane.columns(), all);
  EXPECT_EQ(plane.rows(), all);
  std::size_t finite = 0;
  for (std::size_t i = 0; i < all; ++i) {
    const auto q = query_at(plane, witness, i, 0);
    const Rational scale = plane.along.offset(i) < 0 ? Rational(1) / Rational(mpz_class(1) << -plane.along.offset(i))
                                                     : Rational(mpz_class(1) << plane.along.offset(i));
    EXPECT_EQ(q.a.y, nearest<Real>(Rational(3 * scale)));  // rounded once
    EXPECT_NE(q.a.y, 0);
    finite += std::isfinite(q.a.y);
    EXPECT_TRUE(std::signbit(q.c.z) || plane.along.offset(i) != 0);
  }
  EXPECT_EQ(finite, all);
  const Plane coarse = exponent_plane(witness, numbers_named("scene"), numbers_named("r"), 50);
  EXPECT_LE(coarse.columns(), 50u);
  EXPECT_EQ(coarse.along.offset(coarse.along.origin()), 0);
}

TEST(MapNumbers, AreNamedOrRefused) {
  EXPECT_EQ(numbers_named("p.z").places, one_bit<std::uint16_t>(11));
  EXPECT_EQ(numbers_named("b").places, 7u << 3);
  EXPECT_EQ(numbers_named("triangle").places, 0x1ffu);
  for (const char* wrong : {"", "a.w", "d", "a.", "r.x", "ax"}) EXPECT_THROW(numbers_named(wrong), Error) << wrong;
  EXPECT_THROW(ulp_plane(numbers_named("a"), numbers_named("r"), 4, 1), Error);
  EXPECT_THROW(ulp_plane(numbers_named("r"), numbers_named("r"), 4, 1), Error);
  EXPECT_THROW(exponent_plane(Query<float>{}, numbers_named("a"), numbers_named("r"), 4), Error);
}

// The class that a picture has to show for one query, by everything that `check` asks: CGAL and exact sides, no filter.
template <class Real>
class CheckedPixel {
 public:
  CheckedPixel(const Query<Real>& q, const Kernel& kernel) : is_valid_(is_valid(q)) {
    if (is_valid_) flips_ = Examiner(kernel, scalar_target).examine(q).judgement.flips();
  }
  // Empty if the kernel is right.
  std::optional<PixelClass> expected(const MapSubject& subject) const {
    if (!is_valid_) return PixelClass::no_query;
    for (const Flip& flip : flips_) {
      if (flip.level != subject.level || flip.index != subject.index) continue;
      return flip.kind == FlipKind::false_separation ? PixelClass::false_separation : PixelClass::missed_separation;
    }
    return std::nullopt;
  }
  bool is_wrong() const { return !flips_.empty(); }

 private:
  bool is_valid_;
  std::vector<Flip> flips_;
};

// Returns the number of pixels on which the kernel is wrong.
template <class Real>
std::size_t expect_as_checked(const Kernel& kernel, const Query<Real>& witness, const Plane& plane) {
  const MapPlan plan{&kernel, resolve_target("auto"), stored(witness), plane,
                     has_comparison_maps(kernel) ? map_subjects(sphere_triangle_predicate())
                                                 : std::vector<MapSubject>{{Level::verdict, 0}}};
  std::size_t wrong = 0;
  const auto pictures = draw_map(plan);
  for (std::size_t i = 0; i < plane.columns() * plane.rows(); ++i) {
    const CheckedPixel checked(query_at(plane, witness, i % plane.columns(), i / plane.columns()), kernel);
    wrong += checked.is_wrong();
    for (const MapPicture& picture : pictures) {
      const PixelClass shown = picture.pixels[i];
      const auto due = checked.expected(picture.subject);
      const bool as_due = due ? shown == *due : shown > PixelClass::missed_separation;
      EXPECT_TRUE(as_due) << kernel.id << " " << name(picture.subject, sphere_triangle_predicate()) << ", pixel " << i
                          << ", seed " << seed;
    }
  }
  return wrong;
}

TYPED_TEST(Maps, ShowWhatCheckSays) {
  const Plane plane = ulp_plane(numbers_named("p.x"), numbers_named("r"), 8, 1);
  for (const char* id : {"published", "ladder-0", "closest-point"}) {
    std::size_t wrong = 0;
    for (const std::uint64_t position : {0, 1, 4}) {  // beside the plane, a vertex, an edge
      wrong +=
          expect_as_checked(find_kernel(id), query_from(find_family("tangent").make<TypeParam>(seed, position)), plane);
    }
    EXPECT_GT(wrong, 0u) << id << ", seed " << seed;
  }
  const Query<TypeParam> tangent = find_family("tangent").make<TypeParam>(seed, 4);
  const Plane scales = exponent_plane(tangent, numbers_named("scene"), numbers_named("r"), 8);
  EXPECT_GT(expect_as_checked(find_kernel("published"), tangent, scales), 0u);
}

TEST(MapsOfAVariant, AreHeldAgainstItsOwnFormulae) {
  const Query<float> q = {{1, 0, 0}, {1, 0, 0}, {3, 1, 0}, {0, 0, 0}, 1};
  expect_as_checked(find_kernel("first-publication"), q, ulp_plane(numbers_named("a.x"), numbers_named("r"), 8, 1));
}

// Expected from the geometry alone: a sphere that touches the vertex A of a triangle that is otherwise far from it.
TEST(MapPictures, ShowTheBoundaryTiesAndTheWrongBit) {
  const Query<float> q = {{1, 0, 0}, {2, 1, 0}, {2, -1, 1}, {0, 0, 0}, 1};
  const Plane plane = ulp_plane(numbers_named("a.x"), numbers_named("r"), 8, 1);
  MapPlan plan{&find_kernel("published"), resolve_target("auto"), stored(q), plane,
               map_subjects(sphere_triangle_predicate())};
  const auto verdict = draw_map(plan).front();
  for (std::size_t row = 0; row < 8; ++row) {
    for (std::size_t column = 0; column < 8; ++column) {
      const auto p = query_at(plane, q, column, row);
      const PixelClass shown = verdict.pixels[row * 8 + column];
      if (p.a.x == p.r) {
        EXPECT_EQ(shown, PixelClass::tie);
      } else if (p.a.x > p.r) {
        EXPECT_TRUE(shown == PixelClass::yes || shown == PixelClass::yes_uncertain);
      } else {
        EXPECT_TRUE(shown == PixelClass::no || shown == PixelClass::no_uncertain || shown == PixelClass::boundary);
      }
    }
  }
  const Kernel wrong = published_with_a_wrong_bit(Comparison::edge_bc_radius);
  plan.kernel = &wrong;
  for (const MapPicture& picture : draw_map(plan)) {
    const auto count = [&](PixelClass c) { return picture.counts[c]; };
    const bool is_it = name(picture.subject, sphere_triangle_predicate()) == "edge_bc.radius";
    EXPECT_EQ(count(PixelClass::false_separation) + count(PixelClass::missed_separation) == 64, is_it)
        << name(picture.subject, sphere_triangle_predicate());
  }
}

// A predicate without filters: every pixel of the verdict is as the oracles and the kernel say.
TEST(MapsOfOracles, ShowWhatTheOraclesAndTheKernelSay) {
  // Along a triangle that is a segment, at height 2: strict sides invent a contact for any radius.
  const Numbers<float> q = MovingQuery<float>{{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {1, 0, 2}, {1, 0, 0}, 2};
  const PredicateEntry& columns = moving_sphere_predicate().entries[0];
  const Kernel& strict = find_kernel("moving-sphere/twenty");
  const StoredQuery witness = {"q", Precision::binary32, q, &moving_sphere_predicate()};
  const MapPlan plan{&strict, std::string(scalar_target), witness,
                     ulp_plane(parse_numbers("d.x", columns), parse_numbers("r", columns), 8, 1),
                     map_subjects(moving_sphere_predicate())};
  ASSERT_EQ(plan.subjects.size(), 1u + 20 + 61);
  const std::vector<MapPicture> pictures = draw_map(plan);
  ASSERT_EQ(pictures.size(), plan.subjects.size());
  std::size_t phantoms = 0, touching = 0;
  for (std::size_t i = 0; i < 64; ++i) {
    const Numbers<float> at = query_at(plan.plane, q, i % 8, i / 8);
    const Truth truth = oracles_of(moving_sphere_predicate()).truth(at);
    const Verdict said = ask(strict.on<float>(scalar_target), at).verdicts[0];
    const PixelClass shown = pictures[0].pixels[i];
    const bool is_phantom = truth.verdict == Verdict::separated && said == Verdict::contact;
    EXPECT_EQ(shown == PixelClass::missed_separation, is_phantom) << i;
    EXPECT_EQ(shown == PixelClass::tie, truth.touching) << i;
    phantoms += is_phantom;
    touching += truth.touching;
  }
  EXPECT_EQ(phantoms, 32u) << "the four rows with a radius below 2";
  EXPECT_EQ(touching, 8u);
  EXPECT_EQ(name(plan.subjects[1], moving_sphere_predicate()), "start.plane");
}

TEST(MapNumbers, AreThoseOfTheEntry) {
  const PredicateEntry& columns = moving_sphere_predicate().entries[0];
  EXPECT_EQ(parse_numbers("d.z", columns).places, std::uint64_t{1} << 14);
  EXPECT_EQ(parse_numbers("r", columns).places, std::uint64_t{1} << 15);
  EXPECT_EQ(parse_numbers("scene", columns).places, 0xffffu);
  EXPECT_EQ(parse_numbers("triangle", columns).places, 0x1ffu);
  EXPECT_THROW(parse_numbers("e.x", columns), Error);
}

// 2^11 is still within the range of binary32 at degree 6; at 2^30 an edge's sides overflow and it no longer separates.
TEST(MapPictures, ShowWhereRangeEnds) {
  const Query<float> q = {{1, -1, 0}, {1, 1, 0.25}, {2, 0, 4}, {0, 0, 0}, 0.5};
  const MapPlan plan{&find_kernel("published"),
                     resolve_target("auto"),
                     stored(q),
                     exponent_plane(q, numbers_named("scene"), numbers_named("r"), greatest_map),
                     {{Level::comparison, static_cast<std::uint8_t>(Comparison::edge_ab_radius)}}};
  const MapPicture picture = draw_map(plan).front();
  const std::size_t row = plan.plane.rows() - 1 - plan.plane.across.origin(), at = plan.plane.along.origin();
  const auto shown = [&](std::size_t column) { return picture.pixels[row * plan.plane.columns() + column]; };
  EXPECT_EQ(shown(at), PixelClass::yes);
  EXPECT_EQ(shown(at + 11), PixelClass::yes);
  EXPECT_EQ(shown(at + 30), PixelClass::missed_separation);
  EXPECT_EQ(shown(at - 40), PixelClass::missed_separation);
}

MapPicture verdict_picture(const Kernel& kernel) {
  const Query<float> witness = {{1, 0, 0}, {2, 1, 0}, {2, -1, 1}, {0, 0, 0}, 1};
  const Plane plane = ulp_plane(numbers_named("a.x"), numbers_named("r"), 16, 1 << 16);
  return draw_map({&kernel, std::string(scalar_target), stored(witness), plane, {{Level::verdict, 0}}}).front();
}

TEST(MapAnswers, AreToldApartWhereTheyAreNoVerdict) {
  const std::uint64_t contacts = [] {
    const MapPicture right = verdict_picture(find_kernel("certified"));
    return 256 - right.counts[PixelClass::yes] - right.counts[PixelClass::yes_uncertain];
  }();
  ASSERT_GT(contacts, 0u);
  for (const auto& [said, shown] :
       {std::pair(Verdict::undecided, PixelClass::undecided), std::pair(Verdict::invalid, PixelClass::invalid),
        std::pair(Verdict::unanswered, PixelClass::unanswered)}) {
    const MapPicture some = verdict_picture(saying(said, false));
    EXPECT_EQ(some.counts[shown], contacts) << name(said);
    EXPECT_EQ(some.decided(), 256 - contacts);
    EXPECT_EQ(verdict_picture(saying(said, true)).decided(), 0u);
  }
}

TEST(MapAnswers, OutsideTheLimitsAreNotJudged) {
  Kernel limited = saying(Verdict::separated, false);  // always separated
  EXPECT_GT(verdict_picture(limited).counts[PixelClass::false_separation], 0u);
  limited.limits.least_radius = 100;
  EXPECT_EQ(verdict_picture(limited).counts[PixelClass::outside_limits], 256u);
  EXPECT_EQ(verdict_picture(limited).decided(), 0u);
}

}  // namespace
}  // namespace axiscert
