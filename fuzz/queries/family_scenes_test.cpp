// The families of scenes in metres make what a game has, and hold the sphere as near to the triangles as they say.
#include <cmath>
#include <map>
#include <set>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/queries/family_testing.h"

namespace axiscert {
namespace {

template <class Real>
class SceneFamilies : public testing::Test {};
TYPED_TEST_SUITE(SceneFamilies, Reals);

using Metres = Vec3<double>;
double length_of(const Metres& v) { return std::sqrt(dot(v, v)); }

// How far a vertex at the edge of the world may be from where it was meant.
template <class Real>
constexpr double rounding = std::numeric_limits<Real>::epsilon() * 1000;

// A triangle in binary64, with angles in degrees. Every number of a query is one of binary64; the lengths are rounded.
struct MeasuredTriangle {
  std::array<Metres, 3> v;
  Metres normal;
  double shortest = HUGE_VAL, longest = 0, least_angle = 180;

  template <class Real>
  explicit MeasuredTriangle(const Query<Real>& q) {
    const std::array<Vec3<Real>, 3> corners = {q.a, q.b, q.c};
    for (std::size_t i = 0; i < 3; ++i) v[i] = {double(corners[i].x), double(corners[i].y), double(corners[i].z)};
    normal = cross(v[1] - v[0], v[2] - v[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Metres edge = v[(i + 1) % 3] - v[i];
      shortest = std::min(shortest, length_of(edge));
      longest = std::max(longest, length_of(edge));
      const double angle = std::atan2(length_of(normal), dot(edge, v[(i + 2) % 3] - v[i]));
      least_angle = std::min(least_angle, angle * 180 / M_PI);
    }
  }
};

// A scene that a game could have: in metres, within its world, seen from the front, and nothing in it is subnormal,
// thin or without area.
template <class Real>
void expect_a_game(const Query<Real>& q, const MeasuredTriangle& triangle) {
  ASSERT_TRUE(is_valid(q));
  EXPECT_GE(q.r, Real(0.1));
  EXPECT_LE(q.r, Real(1));
  for (const Real x : coordinates(q)) EXPECT_TRUE(x == 0 || (std::abs(x) > 1e-12 && std::abs(x) < 1300)) << x;
  EXPECT_GE(triangle.least_angle, 6);
  // The third vertex is at least a quarter of an edge of 1 cm away from it.
  EXPECT_GE(triangle.shortest, 0.0025 - 2 * rounding<Real>);
  EXPECT_LE(triangle.longest, 174);
  const Metres centre = Metres{double(q.p.x), double(q.p.y), double(q.p.z)} - triangle.v[0];
  const double area = length_of(triangle.normal), height = area / triangle.longest;
  const double tilted = length_of(centre) * 2 * rounding<Real> / height;  // the plane of a small triangle
  EXPECT_GE(dot(triangle.normal, centre) / area, -2 * rounding<Real> - tilted) << "seen from the front";
}

// Positive where the sphere is clear of the triangle.
template <class Real>
double gap_of(const Query<Real>& q) {
  return std::sqrt(squared_distance(q).get_d()) - double(q.r);
}

TYPED_TEST(SceneFamilies, WalkHoldsTheSphereWithinACentimetreOfTheGround) {
  constexpr double error = rounding<TypeParam>;
  std::size_t usual = 0, floors = 0, contacts = 0, separated = 0;
  std::map<int, int> decades;
  for_each_query<TypeParam>("scene-walk", 27 * 100, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const MeasuredTriangle triangle(q);
    expect_a_game(q, triangle);
    ++decades[static_cast<int>(std::floor(std::log10(triangle.longest)))];
    usual += q.r == TypeParam(0.3);
    const double up = std::max(triangle.normal.y, triangle.normal.z) / length_of(triangle.normal);
    EXPECT_GE(up, sizeof(TypeParam) == 4 ? 0.45 : 0.5)
        << "no steeper than 60 degrees, but for a small triangle's rounding";
    floors += (q.a.z == q.b.z && q.a.z == q.c.z) || (q.a.y == q.b.y && q.a.y == q.c.y);
    ++(distance_order(q) > 0 ? separated : contacts);
    const double gap = gap_of(q);
    EXPECT_GE(gap, -0.01 - error);
    if (position % 3 != 0) return;  // at an edge or a vertex, which the sphere may have passed
    const std::uint64_t held = position / 3 % 3;
    const double least[] = {0, 0.001, -0.01}, greatest[] = {0, 0.01, 0};  // at rest, with a skin, sunk in
    EXPECT_GE(gap, least[held] - error) << held;
    EXPECT_LE(gap, greatest[held] + error) << held;
  });
  EXPECT_GT(usual, 1200u);
  EXPECT_GT(floors, 1200u);
  EXPECT_GT(contacts, 600u);
  EXPECT_GT(separated, 900u);
  for (const int decade : {-2, -1, 0, 1}) EXPECT_GT(decades[decade], 300) << "triangles of 10^" << decade << " m";
}

TYPED_TEST(SceneFamilies, EdgeAsksTheSameSphereOfTwoTrianglesThatShareAnEdge) {
  constexpr double error = rounding<TypeParam>;
  const auto vertices = [](const Query<TypeParam>& q) {
    std::set<std::array<TypeParam, 3>> all;
    for (const auto& v : {q.a, q.b, q.c}) all.insert({v.x, v.y, v.z});
    return all;
  };
  Query<TypeParam> first{};
  std::size_t touched[4][2]{};  // by meeting, at the edge and at its end
  for_each_query<TypeParam>("scene-edge", 2 * 8 * 9 * 20, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const MeasuredTriangle triangle(q);
    expect_a_game(q, triangle);
    EXPECT_GE(gap_of(q), -0.01 - error);
    const std::uint64_t scene = position / 2, meeting = scene % 4;
    if (meeting == 2) {
      EXPECT_TRUE(triangle.longest > 99.9 && triangle.longest < 141.5) << "a wall: " << triangle.longest;
    }
    if (meeting == 3) {
      EXPECT_LE(triangle.longest, 0.1415 + 2 * error) << "a prop";
    }
    if (position % 2 == 0) {
      first = q;
      return;
    }
    EXPECT_TRUE(q.r == first.r && q.p.x == first.p.x && q.p.y == first.p.y && q.p.z == first.p.z);
    std::set<std::array<TypeParam, 3>> both = vertices(first);
    both.merge(vertices(q));
    EXPECT_EQ(both.size(), 4u) << "two vertices are shared";
    const double gap = std::min(gap_of(first), gap_of(q));
    touched[meeting][scene / 4 % 2] += gap <= error;
    if (meeting == 1 || meeting == 3) {
      EXPECT_LE(gap, 0.01 + error) << "the edge or its end is the nearest point of both";
    }
  });
  for (const auto& of_meeting : touched) {
    for (const std::size_t count : of_meeting) {
      EXPECT_GT(count, 30u) << "of 180 scenes, in 120 of which the sphere rests or is sunk in";
    }
  }
}

TYPED_TEST(SceneFamilies, PatchAsksOneSphereOfATriangleAndItsThreeNeighbours) {
  Query<TypeParam> middle{};
  std::size_t held = 0, level = 0, leaning = 0;
  for_each_query<TypeParam>("patch", 4 * 54 * 5, [&](const Query<TypeParam>& q, std::uint64_t position) {
    if (position % 4 == 0) {
      middle = q;
      held += gap_of(q) <= rounding<TypeParam>;
      return;
    }
    EXPECT_TRUE(q.r == middle.r && q.p.x == middle.p.x && q.p.y == middle.p.y && q.p.z == middle.p.z);
    std::size_t shared = 0;
    for (const auto& v : {q.a, q.b, q.c}) {
      for (const auto& w : {middle.a, middle.b, middle.c}) shared += v.x == w.x && v.y == w.y && v.z == w.z;
    }
    EXPECT_EQ(shared, 2u) << "an edge, at " << position;
    const MeasuredTriangle one(q), of_middle(middle);
    const double cosine = dot(one.normal, of_middle.normal) / (length_of(one.normal) * length_of(of_middle.normal));
    EXPECT_GT(cosine, 0.9) << "both are seen from one side, at " << position;
    (cosine > 0.999 ? level : leaning) += 1;
  });
  EXPECT_GT(held, 100u);
  EXPECT_GT(level, 200u);
  EXPECT_GT(leaning, 100u);
}

TYPED_TEST(SceneFamilies, ExtentsAreOfMillimetresAndOfKilometres) {
  std::size_t strips = 0, specks = 0, plains = 0, contacts = 0;
  constexpr std::uint64_t queries = 27 * 40;
  for_each_query<TypeParam>("extents", queries, [&](const Query<TypeParam>& q, std::uint64_t position) {
    const MeasuredTriangle triangle(q);
    contacts += distance_order(q) <= 0;
    EXPECT_TRUE(q.r >= TypeParam(0.0099) && q.r <= 1);
    if (position % 3 == 0) strips += triangle.longest > 199 && triangle.longest < 201;
    if (position % 3 == 1) specks += triangle.longest < 0.03;
    if (position % 3 == 2) plains += triangle.longest > 490;
  });
  EXPECT_EQ(strips, queries / 3);
  EXPECT_EQ(specks, queries / 3);
  EXPECT_EQ(plains, queries / 3);
  EXPECT_GT(contacts, queries / 4);
  EXPECT_LT(contacts, queries * 3 / 4);
}

// A kernel that takes its numbers in any entry can be asked about a game; and what a wrong verdict there says is known.
TEST(SceneFamiliesOfAll, AreThereInEveryEntryAndAreEveryday) {
  for (const Predicate* predicate : predicates()) {
    for (std::size_t entry = 0; entry < predicate->entries.size(); ++entry) {
      std::size_t scenes = 0;
      for (const Family* family : families_of(*predicate, entry)) {
        if (family->trust_group != TrustGroup::scene) continue;
        ++scenes;
        if (family->situation == nullptr) continue;
        EXPECT_EQ(family->situation->name, "everyday") << family->name;
      }
      EXPECT_GT(scenes, 0u) << predicate->id << ", entry " << predicate->entries[entry].name
                            << ": has no family of scenes, whose trust_group is `scene`";
    }
  }
}

}  // namespace
}  // namespace axiscert
