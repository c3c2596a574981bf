// The numbers of contacts compared with exact ones, within their bounds: on every instruction set, in every
// floating-point mode and through every form of the interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "exact/sphere_triangle/certified_contact_truth.h"
#include "exact/sphere_triangle/certified_queries.h"
#include "kernel/base/environment.h"
#include "kernel/include/axiscert/contact.hpp"
#include "kernel/sphere_triangle/certified/contact_steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {
namespace {

using testing_support::ContactSaid, testing_support::what_is_wrong;

constexpr std::uint64_t contact_seed = 20261127;

// A query near which something changes: the nearest part, contact, the direction of a normal.
template <class Real>
std::array<Real, 13> close_query(std::mt19937_64& random) {
  const auto one = [&] { return static_cast<Real>(std::uniform_real_distribution<double>(-1, 1)(random)); };
  const auto small = [&] { return random() % 2 ? Real(0) : std::ldexp(one(), -static_cast<int>(random() % 60)); };
  std::array<Real, 13> q;
  for (Real& x : q) x = one();
  const std::size_t i = 3 * (random() % 3), j = 3 * (random() % 3);
  Real s = std::abs(one()), t = std::abs(one());
  if (s + t > 1) s = 1 - s, t = 1 - t;
  const int kind = static_cast<int>(random() % 9), size = static_cast<int>(random() % (sizeof(Real) == 4 ? 270 : 2090));
  const int least = sizeof(Real) == 4 ? -145 : -1070;
  for (std::size_t k = 0; k < 3; ++k) {
    if (kind == 0) q[6 + k] = q[k] + s * (q[3 + k] - q[k]) + small();  // hardly any area
    if (kind == 1) q[i + k] = q[j + k];
    if (kind == 2) q[9 + k] = q[k] + s * (q[3 + k] - q[k]) + t * (q[6 + k] - q[k]) + small();  // near the face
    if (kind == 3) q[9 + k] = q[i + k] + s * (q[j + k] - q[i + k]) + small();                  // near an edge
    if (kind == 4) q[9 + k] = q[i + k] + small();
  }
  if (kind == 8) {  // above the middle of a thin face
    const Real thin = std::ldexp(one(), -static_cast<int>(random() % (sizeof(Real) == 4 ? 22 : 50)));
    for (std::size_t k = 0; k < 3; ++k) q[6 + k] = q[k] + s * (q[3 + k] - q[k]) + thin * q[6 + k];
    const Vec3<Real> a{q[0], q[1], q[2]}, b{q[3], q[4], q[5]}, c{q[6], q[7], q[8]}, V = cross(b - a, c - a);
    const Real height = q[12] / std::sqrt(dot(V, V));
    const Vec3<Real> centre = (a + b + c) * (Real(1) / 3) + V * height;
    if (std::isfinite(height)) q[9] = centre.x, q[10] = centre.y, q[11] = centre.z;
  } else if (kind >= 5) {
    for (Real& x : q) {
      const int own = static_cast<int>(random() % (sizeof(Real) == 4 ? 270 : 2090));
      const Real whole = static_cast<Real>(static_cast<int>(random() % 9) - 4);
      x = kind == 5 ? whole : kind == 6 ? std::ldexp(x, least + own) : std::ldexp(whole, least + size);
    }
  }
  q[12] = std::abs(q[12]);
  return q;
}

template <class Real>
std::vector<std::array<Real, 13>> hard_queries(std::size_t count) {
  using namespace testing_support;
  std::mt19937_64 random(contact_seed);
  std::vector<std::array<Real, 13>> made;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<Real, 13> q = i % 16 == 0   ? coordinates(random_query<Real>(random, false))
                             : i % 16 == 1 ? coordinates(coarse_query_of_any_size<Real>(random))
                             : i % 16 == 2 ? coordinates(plane_query<Real>(random))
                             : i % 16 <= 4 ? coordinates(integer_query<Real>(random))
                                           : close_query<Real>(random);
    certified::ContactData<Real> at;
    if (i % 3 == 0 && certified::contact(q.data(), q.data() + 9, at) != AXISCERT_INVALID) {  // near contact
      const Real r = q[12] + at.separation;
      if (std::isfinite(r) && r >= 0)
        q[12] = i % 2 ? r : std::nextafter(r, i % 4 ? Real(0) : std::numeric_limits<Real>::max());
    }
    if (i % 256 == 77) q[i / 256 % 13] = std::numeric_limits<Real>::quiet_NaN();
    made.push_back(q);
  }
  return made;
}

// Columns of queries, and the answers to them.
template <class Real>
struct ContactAnswers {
  std::vector<std::uint8_t> verdict, feature, has_normal;
  std::array<std::vector<Real>, 7> number;

  explicit ContactAnswers(std::size_t size) : verdict(size, 99), feature(size, 99), has_normal(size, 99) {
    for (auto& column : number) column.assign(size, Real(99));
  }
  certified::ContactArrays<Real> arrays() {
    auto& n = number;
    return {verdict.data(),
            feature.data(),
            has_normal.data(),
            n[0].data(),
            {n[1].data(), n[2].data(), n[3].data()},
            {n[4].data(), n[5].data(), n[6].data()}};
  }
  ContactSaid said(std::size_t i) const {
    const auto at = [&](std::size_t k) { return static_cast<double>(number[k][i]); };
    return {verdict[i], feature[i], has_normal[i], at(0), {at(1), at(2), at(3)}, {at(4), at(5), at(6)}};
  }
  // To the bit, but that one NaN is as good as another.
  bool is_same(std::size_t i, const ContactAnswers& other, std::size_t j) const {
    bool same =
        verdict[i] == other.verdict[j] && feature[i] == other.feature[j] && has_normal[i] == other.has_normal[j];
    for (std::size_t k = 0; k < 7; ++k) {
      const Real x = number[k][i], y = other.number[k][j];
      same = same && ((x == y && std::signbit(x) == std::signbit(y)) || (std::isnan(x) && std::isnan(y)));
    }
    return same;
  }
};
template <class Real>
struct Columns {
  std::array<std::vector<Real>, 13> storage;
  explicit Columns(const std::vector<std::array<Real, 13>>& queries) {
    for (std::size_t k = 0; k < 13; ++k) {
      for (const auto& q : queries) storage[k].push_back(q[k]);
    }
  }
  std::size_t size() const { return storage[0].size(); }
  std::array<const Real*, 13> pointers(std::size_t from = 0) const {
    std::array<const Real*, 13> made;
    for (std::size_t k = 0; k < 13; ++k) made[k] = storage[k].data() + from;
    return made;
  }
  ContactAnswers<Real> ask(axiscert_question question) const {
    ContactAnswers<Real> found(size());
    certified::contact_pairs(pointers(), size(), question, found.arrays());
    return found;
  }
};

template <class Real>
std::array<double, 13> widened(const std::array<Real, 13>& q) {
  std::array<double, 13> made;
  std::copy(q.begin(), q.end(), made.begin());
  return made;
}

template <class Real>
class ContactTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ContactTest, Reals);

template <class Real>
void expect_right(std::size_t count) {
  const auto queries = hard_queries<Real>(count);
  const Columns<Real> columns(queries);
  std::array<int, 8> features = {};
  for (const axiscert_question question :
       {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE, AXISCERT_EXACT_ONLY, AXISCERT_OPEN_EXACT_ONLY}) {
    const bool open = question == AXISCERT_OPEN_SPHERE || question == AXISCERT_OPEN_EXACT_ONLY;
    const ContactAnswers<Real> found = columns.ask(question);
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(what_is_wrong<Real>(widened(queries[i]), open, found.said(i)), "")
          << "query " << i << " of seed " << contact_seed << ", question " << question << ": "
          << testing::PrintToString(queries[i]);
      ++features[found.feature[i]];
    }
  }
  for (const int count_of_feature : features) EXPECT_GT(count_of_feature, 10);
}
TYPED_TEST(ContactTest, VerdictAndFeatureAreExactAndTheNumbersKeepTheirBounds) { expect_right<TypeParam>(6000); }
template <class Real>
class ContactTestLong : public testing::Test {};
TYPED_TEST_SUITE(ContactTestLong, Reals);
TYPED_TEST(ContactTestLong, VerdictAndFeatureAreExactAndTheNumbersKeepTheirBounds) { expect_right<TypeParam>(1000000); }

// What the tests above look at sees each fault that is twice what is allowed, whichever step judges: floating point,
// integers of one word, two or many.
TYPED_TEST(ContactTest, TheTruthSeesWhatIsWrong) {
  using Real = TypeParam;
  using Promise = testing_support::ContactPromise<Real>;
  const std::array<double, 13> apart = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 2, 1},
                               beyond = {0, 0, 0, 4, 0, 0, 0, 4, 0, 2, -1, 0, 1};
  const ContactSaid touching{0, 3, 1, 0, {0, -1, 0}, {2, 0, 0}};
  ASSERT_EQ(what_is_wrong<Real>(beyond, false, touching), "");
  EXPECT_NE(what_is_wrong<Real>(beyond, true, touching), "") << "an open sphere does not touch";
  const double scene = std::sqrt(14.0);  // |B - P|
  const auto expect_all_seen = [&](std::array<double, 13> q, const ContactSaid& right, int expected_judge) {
    int judge = -1;
    ASSERT_EQ(what_is_wrong<Real>(q, false, right, &judge), "");
    EXPECT_EQ(judge, expected_judge);
    const auto expect_seen = [&](auto&& change) {
      ContactSaid wrong = right;
      change(wrong);
      EXPECT_NE(what_is_wrong<Real>(q, false, wrong), "");
    };
    expect_seen([](ContactSaid& said) { said.verdict = 1 - said.verdict; });
    expect_seen([](ContactSaid& said) { said.feature = 3; });
    expect_seen([](ContactSaid& said) { said.has_normal = 0; });
    for (const int sign : {-1, 1}) {
      expect_seen([&](ContactSaid& said) {
        said.separation += sign * 2 * (Promise::of_separation + Promise::of_scene * scene);
      });
      expect_seen([&](ContactSaid& said) { said.normal[0] = sign * 2 * Promise::normal; });
      expect_seen([&](ContactSaid& said) {
        said.point[1] += sign * 2 * (1.5 * Promise::of_point + Promise::point_of_scene * scene);
      });
    }
    expect_seen([](ContactSaid& said) { said.normal[2] = -1; });
    expect_seen([](ContactSaid& said) { said.point[2] = std::numeric_limits<double>::quiet_NaN(); });
  };
  expect_all_seen(apart, {1, 6, 1, 1, {0, 0, 1}, {1, 1, 0}}, 0);
  for (const double speck : {0.0, 0x1p-80, 0x1p-125}) {
    std::array<double, 13> over_face = apart, over_edge = {0, -4, 0, 4, 0, 0, 0, 0, 0, 1, 1, 2, 1};
    over_face[12] = 2;
    over_face[2] = over_face[5] = over_face[8] = speck;
    expect_all_seen(over_face, {0, 6, 1, 0, {0, 0, 1}, {1, 1, speck}}, 1);
    // The foot on the edge BC, of which it is as near as of the face.
    over_edge[10] = 0;
    over_edge[0] = speck;
    expect_all_seen(over_edge, {1, 4, 1, 1, {0, 0, 1}, {1, 0, 0}}, 1);
  }
}

TYPED_TEST(ContactTest, EveryInstructionSetGivesTheSameBits) {
  using Real = TypeParam;
  const auto queries = hard_queries<Real>(3000);
  const Columns<Real> columns(queries);
  const ContactAnswers<Real> expected = columns.ask(AXISCERT_CLOSED_SPHERE);
  const SimdTable<certified::ContactForms> table([] { return certified::chosen_contact_forms(); });
  for (const std::string& target : simd_targets()) {
    for (const bool one_by_one : {false, true}) {
      const auto decide = one_by_one ? table.on(target).template one<Real>() : table.on(target).template block<Real>();
      ContactAnswers<Real> found(columns.size());
      const certified::DefaultModes modes;
      for (std::size_t first = 0; first < columns.size(); first += certified::block_size) {
        certified::Block<Real> block{{}, std::min(certified::block_size, columns.size() - first), false};
        const auto pointers = columns.pointers(first);
        std::copy(pointers.begin(), pointers.end(), block.column);
        const auto to = found.arrays();
        certified::BlockContacts answer;
        decide(block, certified::Question::closed_sphere,
               {to.separation + first,
                {to.normal[0] + first, to.normal[1] + first, to.normal[2] + first},
                {to.point[0] + first, to.point[1] + first, to.point[2] + first}},
               answer);
        certified::write_verdicts(answer, block.size, found.verdict.data() + first);
        certified::write_features(answer, block.size, found.feature.data() + first);
        certified::write_has_normal(answer, block.size, found.has_normal.data() + first);
      }
      for (std::size_t i = 0; i < columns.size(); ++i) {
        ASSERT_TRUE(found.is_same(i, expected, i))
            << target << ", query " << i << " of seed " << contact_seed << ": " << testing::PrintToString(queries[i]);
      }
    }
  }
}

TYPED_TEST(ContactTest, EveryFloatingPointModeGivesTheSameBitsAndIsLeftAsItWas) {
  using Real = TypeParam;
  const Columns<Real> columns(hard_queries<Real>(1000));
  const ContactAnswers<Real> expected = columns.ask(AXISCERT_CLOSED_SPHERE);
  for (const Rounding rounding : {Rounding::nearest, Rounding::upward, Rounding::downward, Rounding::toward_zero}) {
    for (const bool flush : {false, true}) {
      ContactAnswers<Real> found(columns.size());
      {
        const FloatingEnvironment callers(rounding, flush);
        const std::uint64_t before = FloatingEnvironment::control();
        certified::contact_pairs(columns.pointers(), columns.size(), AXISCERT_CLOSED_SPHERE, found.arrays());
        EXPECT_EQ(FloatingEnvironment::control() & ~std::uint64_t{0x3f}, before & ~std::uint64_t{0x3f});
      }
      for (std::size_t i = 0; i < columns.size(); ++i) ASSERT_TRUE(found.is_same(i, expected, i)) << "query " << i;
    }
  }
}

TYPED_TEST(ContactTest, OnePairIsTheSameAndNullArraysAreNotWritten) {
  using Real = TypeParam;
  const auto queries = hard_queries<Real>(1000);
  const Columns<Real> columns(queries);
  const ContactAnswers<Real> expected = columns.ask(AXISCERT_OPEN_SPHERE);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    certified::ContactData<Real> at;
    ContactAnswers<Real> found(1);
    found.verdict[0] = static_cast<std::uint8_t>(
        certified::contact(queries[i].data(), queries[i].data() + 9, at, AXISCERT_OPEN_SPHERE));
    found.feature[0] = at.feature;
    found.has_normal[0] = at.has_normal;
    found.number[0][0] = at.separation;
    for (std::size_t k = 0; k < 3; ++k) found.number[1 + k][0] = at.normal[k], found.number[4 + k][0] = at.point[k];
    ASSERT_TRUE(found.is_same(0, expected, i)) << "query " << i;
  }
  ContactAnswers<Real> some(columns.size());
  certified::ContactArrays<Real> arrays = some.arrays();
  arrays.verdict = arrays.has_normal = nullptr;
  arrays.normal[1] = arrays.point[0] = nullptr;
  const axiscert_counts counts =
      certified::contact_pairs(columns.pointers(), columns.size(), AXISCERT_OPEN_SPHERE, arrays);
  EXPECT_EQ(counts.contacts, static_cast<std::size_t>(std::count(expected.verdict.begin(), expected.verdict.end(), 0)));
  EXPECT_EQ(counts.invalid, static_cast<std::size_t>(std::count(expected.verdict.begin(), expected.verdict.end(), 3)));
  EXPECT_EQ(some.feature, expected.feature);
  EXPECT_EQ(std::count(some.verdict.begin(), some.verdict.end(), 99), static_cast<std::ptrdiff_t>(columns.size()));
  EXPECT_EQ(std::count(some.number[2].begin(), some.number[2].end(), Real(99)),
            static_cast<std::ptrdiff_t>(columns.size()));
}

TEST(ContactOfNothing, ReadsNoArray) {
  const float* const columns[13] = {};
  for (const axiscert_question question : {AXISCERT_CLOSED_SPHERE, AXISCERT_EXACT_ONLY}) {
    EXPECT_EQ(axiscert_contact_pairs_f32(nullptr, 0, question, nullptr).contacts, 0u);
    EXPECT_EQ(axiscert_contact_pairs_f32(columns, 0, question, nullptr).contacts, 0u);
    EXPECT_EQ(axiscert_contact_pairs_f64(nullptr, 0, question, nullptr).contacts, 0u);
  }
}

// The contacts of a mesh one after the other, as pairs have them.
TYPED_TEST(ContactTest, AMeshGivesItsContactsAlone) {
  using Real = TypeParam;
  std::mt19937_64 random(contact_seed);
  std::vector<Real> vertices;
  for (int i = 0; i < 200; ++i) {
    const auto q = testing_support::random_query<Real>(random, false);
    vertices.insert(vertices.end(), {q.a.x, q.a.y, q.a.z, std::numeric_limits<Real>::quiet_NaN()});
  }
  constexpr std::size_t triangles = 1000, first = 17;
  std::vector<std::uint32_t> indices, list;
  for (std::size_t i = 0; i < 3 * triangles; ++i) indices.push_back(static_cast<std::uint32_t>(random() % 200));
  for (std::size_t i = first; i < triangles; ++i) list.push_back(static_cast<std::uint32_t>(i));
  const Real sphere[4] = {Real(0.1), Real(-0.2), Real(0.3), Real(0.4)};
  const certified::Mesh<Real> mesh{vertices.data(), 4, indices.data()};
  for (const axiscert_question question : {AXISCERT_CLOSED_SPHERE, AXISCERT_EXACT_ONLY}) {
    ContactAnswers<Real> of_range(list.size()), of_list(list.size());
    std::vector<std::uint32_t> hits(list.size()), listed(list.size());
    const axiscert_counts counts =
        certified::contact_mesh_range(sphere, mesh, first, list.size(), question, hits.data(), of_range.arrays());
    EXPECT_EQ(
        certified::contact_mesh_list(sphere, mesh, list.data(), list.size(), question, listed.data(), of_list.arrays())
            .contacts,
        counts.contacts);
    EXPECT_EQ(of_range.verdict[0], 99);
    std::size_t next = 0;
    for (const std::uint32_t t : list) {
      std::array<Real, 13> q;
      for (std::size_t k = 0; k < 9; ++k) q[k] = vertices[4 * indices[3 * t + k / 3] + k % 3];
      std::copy_n(sphere, 4, q.begin() + 9);
      ContactAnswers<Real> pair = Columns<Real>({q}).ask(question);
      if (pair.verdict[0] != AXISCERT_CONTACT) continue;
      ASSERT_LT(next, counts.contacts);
      EXPECT_EQ(hits[next], t);
      EXPECT_EQ(listed[next], t);
      pair.verdict[0] = 99;
      EXPECT_TRUE(of_range.is_same(next, pair, 0));
      EXPECT_TRUE(of_list.is_same(next, pair, 0));
      ++next;
    }
    EXPECT_EQ(next, counts.contacts);
    EXPECT_GT(next, 300u) << "more than a block";
    EXPECT_EQ(of_range.feature[next], 99);
  }
}

// Where the centre is on the triangle no normal exists; the documented one is given.
TYPED_TEST(ContactTest, AChosenNormalIsTheFacesOrAcrossTheLongestEdge) {
  using Real = TypeParam;
  const auto normal_of = [](const std::array<Real, 13>& q) {
    certified::ContactData<Real> at;
    EXPECT_EQ(certified::contact(q.data(), q.data() + 9, at), AXISCERT_CONTACT);
    EXPECT_EQ(at.has_normal, 0);
    EXPECT_EQ(at.separation, -q[12]);
    return std::array<Real, 3>{at.normal[0], at.normal[1], at.normal[2]};
  };
  using Three = std::array<Real, 3>;
  EXPECT_EQ(normal_of({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 0, 1}), (Three{0, 0, 1}));
  EXPECT_EQ(normal_of({0, 0, 0, 0, 4, 0, 4, 0, 0, 1, 0, 0, 1}), (Three{0, 0, -1}));
  EXPECT_EQ(normal_of({0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 0, 0, 0}), (Three{0, 0, 1}));
  EXPECT_EQ(normal_of({0, 0, 0, 0, 0, 4, 0, 0, 1, 0, 0, 1, 2})[2], 0);
  EXPECT_EQ(normal_of({1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3, 2}), (Three{0, 0, 1}));
}

}  // namespace
}  // namespace axiscert
