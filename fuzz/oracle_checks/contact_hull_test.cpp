// The numbers beside the verdict of boxes against CGAL's hull of the differences of their corners, and against its
// quadratic program for the distance: neither knows of axes, or that anything is a box.
#include <CGAL/Gmpq.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_3.h>
#include <gtest/gtest.h>

#include "exact/boxes/contact.h"
#include "exact/boxes/trait.h"
#include "exact/boxes/triangle_trait.h"
#include "exact/judge/oracles.h"
#include "exact/numbers/roots.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert::boxes {
namespace {

using HullNumber = CGAL::Gmpq;
using HullKernel = CGAL::Simple_cartesian<HullNumber>;
using Corners = std::vector<HullKernel::Point_3>;

HullNumber hull_number(const Rational& x) { return HullNumber(x.get_mpq_t()); }
Rational rational_of(const HullNumber& x) { return Rational(x.mpq()); }

Corners differences(const Hull& a, const Hull& b) {
  Corners found;
  for (const Point& p : a) {
    for (const Point& q : b) found.emplace_back(hull_number(p.x - q.x), hull_number(p.y - q.y), hull_number(p.z - q.z));
  }
  return found;
}

bool is_flat(const Corners& points) {
  const HullKernel::Point_3& first = points.front();
  for (const auto& p : points) {
    for (const auto& q : points) {
      if (CGAL::collinear(first, p, q)) continue;
      return std::ranges::all_of(points, [&](const auto& r) { return CGAL::coplanar(first, p, q, r); });
    }
  }
  return true;
}

// The square of the distance of 0 from the hull.
Rational squared_distance_of(const Corners& points) {
  CGAL::Quadratic_program<HullNumber> program(CGAL::EQUAL, true, HullNumber(0), false);
  const auto count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j <= i; ++j) program.set_d(i, j, 2 * ((points[i] - CGAL::ORIGIN) * (points[j] - CGAL::ORIGIN)));
    program.set_a(i, 0, HullNumber(1));
  }
  program.set_b(0, HullNumber(1));
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_quadratic_program(program, HullNumber(), options);
  return rational_of(solution.objective_value_numerator() / solution.objective_value_denominator());
}

// The planes of the hull's facets: outwards, and how far 0 is behind each, times the normal's length.
struct Facet {
  Point out;
  Rational behind;
};
std::vector<Facet> facets_of(const Corners& points) {
  CGAL::Polyhedron_3<HullKernel> hull;
  CGAL::convex_hull_3(points.begin(), points.end(), hull);
  std::vector<Facet> found;
  for (auto f = hull.facets_begin(); f != hull.facets_end(); ++f) {
    const auto h = f->halfedge();
    const auto &p = h->vertex()->point(), &q = h->next()->vertex()->point(), &r = h->next()->next()->vertex()->point();
    const HullKernel::Vector_3 out = CGAL::cross_product(q - p, r - p);
    found.push_back(
        {{rational_of(out.x()), rational_of(out.y()), rational_of(out.z())}, rational_of(out * (p - CGAL::ORIGIN))});
  }
  return found;
}
Rational squared_behind(const Facet& facet) {
  return facet.behind * facet.behind / Rational(dot(facet.out, facet.out));
}

// The penetration that is left at `pushed`, to 200 bits.
Rational penetration_at(const std::vector<Facet>& facets, const Point& pushed) {
  std::optional<Rational> least;
  for (const Facet& facet : facets) {
    Rational here = (facet.behind - dot(facet.out, pushed)) / root_below(Rational(dot(facet.out, facet.out)));
    if (!least || here < *least) least = std::move(here);
  }
  return *least;
}

struct Counts {
  int apart = 0, deep = 0, tilted = 0, unique = 0;
};

template <class Bodies>
void compare(const Bodies& q, const Hull& a, const Hull& b, const Point& tilt, Counts& counts) {
  const ExactContact found(q);
  const Corners points = differences(a, b);
  if (found.is_apart()) {
    // The plane through the nearest point at right angles to the normal proves the least distance.
    ++counts.apart;
    if (counts.apart % 8 == 1) {
      ASSERT_EQ(found.squared_separation(), squared_distance_of(points));
    }
    ASSERT_GT(found.squared_separation(), 0);
    return;
  }
  if (is_flat(points)) {
    ASSERT_EQ(found.squared_separation(), 0);
    return;
  }
  const std::vector<Facet> facets = facets_of(points);
  std::optional<Rational> least;
  for (const Facet& facet : facets) {
    ASSERT_GE(facet.behind, 0);
    if (Rational here = squared_behind(facet); !least || here < *least) least = std::move(here);
  }
  ASSERT_EQ(found.squared_separation(), *least);
  if (*least == 0) return;
  ++counts.deep;
  // The normals are those of the nearest facets, each once; a facet of several triangles has several.
  const auto same_way = [](const Point& u, const Point& v) {
    const Point turn = cross(u, v);
    return dot(turn, turn) == 0 && dot(u, v) > 0;
  };
  std::vector<Point> normals;
  for (const Facet& facet : facets) {
    if (squared_behind(facet) == *least &&
        std::ranges::none_of(normals, [&](const Point& n) { return same_way(n, facet.out); }))
      normals.push_back(facet.out);
  }
  ASSERT_EQ(found.normals().size(), normals.size());
  for (const Point& normal : normals) {
    ASSERT_TRUE(std::ranges::any_of(found.normals(), [&](const Point& n) { return same_way(n, normal); }));
    ASSERT_TRUE(found.left(normal).is_zero());
  }
  counts.unique += found.only_points().has_value();
  if (found.only_points()) {
    const auto& [at_a, at_b] = *found.only_points();
    ASSERT_EQ(found.squared_distance_from_a(at_a), 0);
    ASSERT_EQ(found.squared_distance_from_b(at_b), 0);
    ASSERT_EQ(found.mismatch(at_a, at_b), 0);
    ASSERT_TRUE(same_way(at_a - at_b, normals.front()));
  }
  // By the definition: B is pushed, to 200 bits, and its penetration taken again.
  for (const Point& n : {Point(normals.front() + tilt * Rational(1, 1000)), tilt, Point(Point{} - normals.front())}) {
    const Rational length = dot(n, n);
    if (length == 0) continue;
    const Rational depth = root_below(*least), step = depth / root_below(length);
    const Rational share = penetration_at(facets, n * step) / depth;
    const Decimal6 left = found.left(n);
    const Rational slack = Rational(mpz_class(1), mpz_class(1) << 200);
    ASSERT_LE(share, exact(left) + slack);
    if (left.is_zero()) continue;
    ++counts.tilted;
    ASSERT_GT(share, exact(previous(left)) - slack);
  }
}

template <class Trait, class Real>
void compare_query(const Numbers<Real>& given, const Point& tilt, Counts& counts) {
  Numbers<double> numbers(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) numbers[k] = static_cast<double>(given[k]);
  if (!Trait::is_valid(numbers)) return;
  const auto q = Trait::exactly(numbers);
  if constexpr (requires { q.a; }) compare(q, corners_of(q.a), corners_of(q.b), tilt, counts);
  else compare(q, corners_of(q.box), hull_of(q.corner), tilt, counts);
}

template <class Real, class... Traits>
void compare_families(const Predicate& predicate, std::uint64_t queries) {
  Counts counts;
  for (const Family* family : families_of(predicate)) {
    for (std::uint64_t i = 0; i < queries; ++i) {
      SCOPED_TRACE(testing::Message() << family->name << ", seed 1, query " << i);
      const Numbers<Real> numbers = family->make<Real>(1, i);
      const auto part = [&](std::uint64_t k) { return Rational(static_cast<long>((i * (2 * k + 3) + k) % 7) - 3); };
      const Point tilt{part(1), part(2), part(3)};
      const auto ask = [&]<class Trait>() {
        if (family->entry == Trait::entry) compare_query<Trait, Real>(numbers, tilt, counts);
      };
      (ask.template operator()<Traits>(), ...);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  std::cout << predicate.id << ": " << counts.apart << " apart, " << counts.deep << " deep, " << counts.unique
            << " of them with one pair of points, " << counts.tilted << " pushes" << std::endl;
  EXPECT_GT(counts.apart, 0);
  EXPECT_GT(counts.deep, 0);
  EXPECT_GT(counts.unique, 0);
  EXPECT_GT(counts.tilted, 0);
}

template <class Real>
class ContactHullLong : public testing::Test {};
using HullReals = testing::Types<float, double>;
TYPED_TEST_SUITE(ContactHullLong, HullReals);

TYPED_TEST(ContactHullLong, OfTwoBoxesIsTheHullOfTheirDifferences) {
  compare_families<TypeParam, MatrixTrait, QuaternionTrait, MinmaxPairTrait, MixedTrait>(box_box_predicate(),
                                                                                         40 / TRIAL_DIVISOR);
}
TYPED_TEST(ContactHullLong, OfABoxAndATriangleIsTheHullOfTheirDifferences) {
  compare_families<TypeParam, CentreTrait, MinmaxTrait, OrientedTrait, TurnedTriangleTrait>(box_triangle_predicate(),
                                                                                            40 / TRIAL_DIVISOR);
}

}  // namespace
}  // namespace axiscert::boxes
