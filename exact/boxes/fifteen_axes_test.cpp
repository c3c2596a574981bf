// The theorem of the fifteen axes, and of the thirteen of a box and a triangle: over the reals, with products of the
// boxes' own vectors and whole projections, they are right; and what each shorter form gets wrong, at which rate.
#include "exact/boxes/boxes_testing.h"
#include "kernel/boxes/textbook.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {
namespace {

constexpr std::uint64_t fifteen_seed = 20261124;

// Wrong verdicts of F on small integers, where doubles are exact, against the nearest points. make(random, i) is query
// i and `seen` what F is asked in its place.
template <class F, class Make, class Seen>
Wrong wrong_of(int queries, Make make, Seen seen) {
  Random random(fifteen_seed);
  Wrong wrong;
  for (int i = 0; i < queries; ++i) {
    const BoxPair<double> q = make(random, i);
    wrong.count(separates<F>(seen(q)), are_apart(q));
  }
  return wrong;
}
template <class F, class Make>
Wrong wrong_of(int queries, Make make) {
  return wrong_of<F>(queries, make, [](const BoxPair<double>& q) { return q; });
}

BoxPair<double> small_pair(Random& random, int i) { return independent_pair(random, 1 + i % 3, 2 + i % 3); }

TEST(FifteenAxes, AreRightOnIndependentAxes) { EXPECT_EQ(wrong_of<ProjectedFifteen>(1500, small_pair).all(), 0); }

TEST(FifteenAxesLong, AreRightOn75000PairsOfIndependentAxes) {
  const Wrong wrong = wrong_of<ProjectedFifteen>(75000 / TRIAL_DIVISOR, small_pair);
  EXPECT_EQ(wrong.all(), 0);
}

// Such boxes are not valid queries; the formulae alone are asked.
TEST(FifteenAxesLong, OfDependentAxesInventAFewContactsAndMissNone) {
  const auto dependent = [](Random& random, int) {
    for (;;) {
      const OrientedBox<double> a = small_box(random, 2, 5), b = small_box(random, 2, 5);
      if (volume(a) == 0 || volume(b) == 0) return BoxPair<double>{a, b};
    }
  };
  const Wrong wrong = wrong_of<ProjectedFifteen>(25000 / TRIAL_DIVISOR, dependent);
  EXPECT_EQ(wrong.missed, 0) << wrong;
  if (TRIAL_DIVISOR == 1) {
    EXPECT_GT(wrong.phantom, 0) << wrong;
  }
  EXPECT_LT(wrong.phantom, wrong.asked / 100) << wrong;
}

struct Rates {
  Wrong columns, textbook, half_edges;
};
Rates rates(int queries) {
  const auto half_edges = [](const BoxPair<double>& q) {
    return BoxPair<double>{by_half_edges(q.a), by_half_edges(q.b)};
  };
  return {wrong_of<Columns>(queries, small_pair), wrong_of<Textbook>(queries, small_pair),
          wrong_of<ProjectedFifteen>(queries, small_pair, half_edges)};
}
void expect_rates(const Rates& found) {
  EXPECT_EQ(found.columns.missed, 0);
  expect_about(found.columns.phantom, found.columns.asked, 930, 50000);
  expect_about(found.textbook.all(), found.textbook.asked, 13978, 25000);
  EXPECT_EQ(found.half_edges.missed, 0);
  expect_about(found.half_edges.phantom, found.half_edges.asked, 535, 25000);
}

TEST(FifteenAxesLong, ShorterFormsAreWrongOnAxesThatAreNotOrthogonal) { expect_rates(rates(25000 / TRIAL_DIVISOR)); }

// Integer columns at right angles: M(q), and two of its columns in other lengths.
BoxPair<double> orthogonal_pair(Random& random, int) {
  const auto box = [&] {
    std::array<double, 4> q;
    do {
      for (double& x : q) x = whole(random, 1);
    } while (std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }));
    OrientedBox<double> made = small_box(random, 1, 10);
    made.axis = turn_of(q).column;
    for (Vec3<double>& v : made.axis) v = v * static_cast<double>(1 + below(random, 2));
    return made;
  };
  const OrientedBox<double> a = box();
  return {a, box()};
}

TEST(FifteenAxes, ColumnsOfAnyLengthAreRightWhereTheyAreOrthogonalAndTheTextbookIsNot) {
  EXPECT_EQ(wrong_of<Columns>(1000, orthogonal_pair).all(), 0);
  EXPECT_EQ(wrong_of<DroppedFifteen>(1000, orthogonal_pair).all(), 0);
  EXPECT_GT(wrong_of<Textbook>(1000, orthogonal_pair).missed, 100);
}

TEST(FifteenAxesLong, ColumnsOfAnyLengthAreRightWhereTheyAreOrthogonalAndTheTextbookMissesAFifth) {
  const int queries = 25000 / TRIAL_DIVISOR;
  const Wrong columns = wrong_of<Columns>(queries, orthogonal_pair);
  EXPECT_EQ(columns.all(), 0);
  const Wrong textbook = wrong_of<Textbook>(queries, orthogonal_pair);
  expect_about(textbook.missed, textbook.asked, 5196, 25000);
}

// Small integer quaternions; in turn anywhere, touching by a rounded factor, parallel, and with half extents of 0.
TurnedPair<double> orthonormal_pair(Random& random, int i) {
  const auto quaternion = [&] {
    std::array<double, 4> q;
    do {
      for (double& x : q) x = whole(random, 3);
    } while (std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }));
    return q;
  };
  TurnedPair<double> q;
  for (TurnedBox<double>* box : {&q.a, &q.b}) {
    box->centre = {0, 0, 0};
    for (double& s : box->half) s = 1 + below(random, 4);
    box->q = quaternion();
  }
  if (i % 4 == 2) q.b.q = q.a.q;
  if (i % 4 == 3) {
    q.a.half[static_cast<std::size_t>(below(random, 3))] = 0;
    q.b.half[static_cast<std::size_t>(below(random, 3))] = 0;
  }
  q.b.centre = whole_vector(random, 6);
  if (i % 4 == 1 && dot(q.b.centre, q.b.centre) != 0) {
    const Vec3<double> u = q.b.centre;
    const double factor = nearest<double>(critical_factor(exact_pair(q), {u.x, u.y, u.z}));
    q.b.centre = u * (factor * (1 + (below(random, 4) - 2) * 0x1p-40));
  }
  return q;
}

struct OrthonormalRates {
  Wrong projected, textbook, homogeneous, epsilon;
};
OrthonormalRates orthonormal_rates(int queries) {
  Random random(fifteen_seed);
  OrthonormalRates found;
  for (int i = 0; i < queries; ++i) {
    const TurnedPair<double> q = orthonormal_pair(random, i);
    const auto problem = exact_problem<QuaternionBoxes>(numbers_of(q));
    const BoxPair<ExactNumber> matrices = with_matrices(problem);
    const bool apart = are_apart(exact_pair(q));
    found.projected.count(separates<ProjectedFifteen, ExactNumber>(matrices), apart);
    found.textbook.count(separates<Textbook, ExactNumber>(matrices), apart);
    found.epsilon.count(separates<Gottschalk, ExactNumber>(matrices), apart);
    found.homogeneous.count(separates<Homogeneous, ExactNumber>(problem), apart);
  }
  return found;
}

TEST(FifteenAxes, TheTextbookIsRightOnExactlyOrthonormalBoxes) {
  const OrthonormalRates found = orthonormal_rates(240);
  EXPECT_EQ(found.projected.all(), 0) << found.projected;
  EXPECT_EQ(found.textbook.all(), 0) << found.textbook;
  EXPECT_EQ(found.homogeneous.all(), 0) << found.homogeneous;
  EXPECT_EQ(found.epsilon.missed, 0) << found.epsilon;
  EXPECT_GT(found.epsilon.phantom, 5) << found.epsilon;
}

TEST(FifteenAxesLong, TheTextbookIsRightOn25600ExactlyOrthonormalPairs) {
  const OrthonormalRates found = orthonormal_rates(25600 / TRIAL_DIVISOR);
  EXPECT_EQ(found.projected.all(), 0) << found.projected;
  EXPECT_EQ(found.textbook.all(), 0) << found.textbook;
  EXPECT_EQ(found.homogeneous.all(), 0) << found.homogeneous;
  EXPECT_EQ(found.epsilon.missed, 0) << found.epsilon;
  expect_about(found.epsilon.phantom, found.epsilon.asked, 2079, 25600);
}

// Every other triangle has no area.
struct ThirteenRates {
  Wrong products, half_edges;
};
ThirteenRates thirteen_rates(int queries) {
  Random random(fifteen_seed);
  ThirteenRates found;
  for (int i = 0; i < queries; ++i) {
    BoxAndTriangle<double> q{independent_box(random, 1 + i % 2, 3), {}};
    for (Vec3<double>& v : q.corner) v = whole_vector(random, 3);
    if (i % 2 == 0) q.corner[2] = q.corner[0] + (q.corner[1] - q.corner[0]) * whole(random, 1);
    Hull triangle;
    for (const Vec3<double>& v : q.corner) triangle.push_back({v.x, v.y, v.z});
    const ExactPair box = exact_pair(BoxPair<double>{q.box, q.box});
    const bool apart = squared_distance(corners_of(box.a), triangle) > 0;
    found.products.count(separates<Thirteen>(q), apart);
    found.half_edges.count(separates<Thirteen>(BoxAndTriangle<double>{by_half_edges(q.box), q.corner}), apart);
  }
  return found;
}

TEST(ThirteenAxes, OfABoxAndATriangleAreRight) {
  const ThirteenRates found = thirteen_rates(1500);
  EXPECT_EQ(found.products.all(), 0) << found.products;
  EXPECT_EQ(found.half_edges.missed, 0) << found.half_edges;
  EXPECT_GT(found.half_edges.phantom, 10) << found.half_edges;
}

TEST(ThirteenAxesLong, OfABoxAndATriangleAreRightOn24000Pairs) {
  const ThirteenRates found = thirteen_rates(24000 / TRIAL_DIVISOR);
  EXPECT_EQ(found.products.all(), 0) << found.products;
  expect_about(found.half_edges.phantom, found.half_edges.asked, 759, 24000);
}

}  // namespace
}  // namespace axiscert::boxes
