// Every registered kernel on hand-worked queries, in every vertex order, in both precisions and on every target.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/table_testing.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::behaviours, testing_support::behaviours_place,
    testing_support::Behaviour, testing_support::BehaviourRow, testing_support::for_each_vertex_order,
    testing_support::row_text, testing_support::Says;

template <class Real>
using Queries = std::vector<Query<Real>>;

// A right triangle in z = 0. Every distance below is an integer or, in the comments, a square root, and every operation
// of every kernel on these numbers is exact except the roots.
template <class Real>
Query<Real> sphere_at(Vec3<Real> p, Real r) {
  return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, r};
}

template <class Real>
Queries<Real> clear_separations() {
  return {sphere_at<Real>({1, 1, 3}, 1),    // the face, at distance 3
          sphere_at<Real>({1, -3, 0}, 1),   // AB, 3
          sphere_at<Real>({4, 4, 1}, 1),    // BC, 3
          sphere_at<Real>({-3, 1, 0}, 1),   // CA, 3
          sphere_at<Real>({-3, -3, 1}, 1),  // A, sqrt(19)
          sphere_at<Real>({9, -1, 0}, 1),   // B, sqrt(26)
          sphere_at<Real>({-1, 9, 0}, 1)};  // C, sqrt(26)
}
template <class Real>
Queries<Real> overlaps() {
  constexpr auto half = Real(0.5);
  return {sphere_at<Real>({1, 1, half}, 1), sphere_at<Real>({2, -half, 0}, 1), sphere_at<Real>({-half, -half, 0}, 1)};
}
template <class Real>
Queries<Real> contacts() {
  Queries<Real> all = overlaps<Real>();
  all.push_back(sphere_at<Real>({1, 1, 0}, 100));  // the whole triangle inside
  all.push_back(sphere_at<Real>({1, 1, 0}, 0));    // a point on the face
  all.push_back(sphere_at<Real>({1, 1, 2}, 2));    // touching the face
  all.push_back(sphere_at<Real>({1, -2, 0}, 2));   // touching an edge
  all.push_back(sphere_at<Real>({-3, -4, 0}, 5));  // touching a vertex with a right angle
  all.push_back(sphere_at<Real>({7, -4, 0}, 5));   // touching a vertex without a right angle
  return all;
}

template <class Real>
Query<Real> sphere_at_origin(Vec3<Real> a, Vec3<Real> b, Vec3<Real> c, Real r) {
  return {a, b, c, {0, 0, 0}, r};
}
template <class Real>
Queries<Real> repeated(Real r) {
  return {sphere_at_origin<Real>({2, 0, 0}, {2, 0, 0}, {3, 0, 0}, r),     // nearest at the repeated vertex, at distance
                                                                          // 2
          sphere_at_origin<Real>({-2, 3, 0}, {-2, 3, 0}, {2, 3, 0}, r)};  // nearest between the vertices, at distance 3
}
template <class Real>
Queries<Real> collinear(Real r) {
  return {sphere_at_origin<Real>({-2, 3, 0}, {1, 3, 0}, {2, 3, 0}, r),
          sphere_at_origin<Real>({-1, 3, 0}, {1, 3, 0}, {3, 3, 0}, r)};
}
template <class Real>
Queries<Real> point(Real r) {
  return {sphere_at_origin<Real>({3, 0, 0}, {3, 0, 0}, {3, 0, 0}, r)};
}

// The clear separations with each coordinate from `first` to before `last` replaced in turn.
template <class Real>
Queries<Real> with(std::initializer_list<Real> values, std::size_t first, std::size_t last) {
  Queries<Real> all;
  for (const Query<Real>& q : clear_separations<Real>()) {
    for (std::size_t k = first; k < last; ++k) {
      for (const Real value : values) {
        auto v = coordinates(q);
        v[k] = value;
        all.push_back(from_coordinates(v));
      }
    }
  }
  return all;
}

// The kernel's answers to all queries in all vertex orders on all of its targets.
struct HeardAnswers {
  int contacts = 0, separations = 0, invalid = 0, undecided = 0;
  bool all(Verdict v) const { return never_other(v) && (v == Verdict::undecided || undecided == 0); }
  // Each answer is `v` or undecided.
  bool never_other(Verdict v) const {
    return (v == Verdict::contact || contacts == 0) && (v == Verdict::separated || separations == 0) &&
           (v == Verdict::invalid || invalid == 0);
  }
};
template <class Real>
HeardAnswers ask(const Kernel& kernel, const Queries<Real>& queries) {
  HeardAnswers heard;
  for (const Query<Real>& original : queries) {
    for_each_vertex_order(original, [&](const Query<Real>& q, std::string_view) {
      for (const std::string& target :
           kernel.has_simd ? available_targets() : std::vector{std::string(scalar_target)}) {
        const Verdict verdict = answer(kernel, q, target).verdict;
        heard.contacts += verdict == Verdict::contact;
        heard.separations += verdict == Verdict::separated;
        heard.invalid += verdict == Verdict::invalid;
        heard.undecided += verdict == Verdict::undecided;
      }
    });
  }
  return heard;
}

Says summary(const HeardAnswers& heard, Says if_separated) {
  return heard.all(Verdict::separated)                                          ? if_separated
         : heard.all(Verdict::contact)                                          ? Says::contact
         : heard.all(Verdict::invalid)                                          ? Says::invalid
         : heard.all(Verdict::undecided)                                        ? Says::undecided
         : if_separated == Says::right && heard.never_other(Verdict::separated) ? Says::declines
                                                                                : Says::varies;
}

// The row that the table would need for the kernel.
template <class Real>
Behaviour heard_of(const Kernel& kernel) {
  constexpr Real inf = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
  const HeardAnswers apart = ask(kernel, clear_separations<Real>()), together = ask(kernel, contacts<Real>());
  Queries<Real> negative = {overlaps<Real>()[0], overlaps<Real>()[1]};
  for (Query<Real>& q : negative) q.r = -q.r;  // squaring forgets the sign of r
  return {apart.all(Verdict::separated) && together.all(Verdict::contact)                   ? Says::right
          : apart.never_other(Verdict::separated) && together.never_other(Verdict::contact) ? Says::declines
                                                                                            : Says::wrong,
          summary(ask(kernel, repeated<Real>(1)), Says::right),
          summary(ask(kernel, collinear<Real>(1)), Says::right),
          summary(ask(kernel, point<Real>(1)), Says::right),
          summary(ask(kernel, with({nan}, 0, 9)), Says::separated),
          summary(ask(kernel, with({inf, -inf}, 0, 9)), Says::separated),
          summary(ask(kernel, with({inf, -inf}, 9, 12)), Says::separated),
          summary(ask(kernel, negative), Says::separated)};
}

// The rows of kernels that exist; RowsAreThoseOfTheRegistry says which do not.
template <class Body>
void for_each_row(Body&& body) {
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate != &sphere_triangle_predicate()) continue;
    for (const BehaviourRow& row : behaviours()) {
      if (row.kernel == kernel.id) body(kernel, row.behaviour);
    }
  }
}

template <class Real>
class BehaviourTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(BehaviourTest, Reals);

TYPED_TEST(BehaviourTest, RowsAreThoseOfTheRegistry) {
  std::vector<std::string> rows, ids;
  for (const BehaviourRow& row : behaviours()) rows.push_back(row.kernel);
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate != &sphere_triangle_predicate()) continue;
    ids.push_back(kernel.id);
    EXPECT_EQ(std::count(rows.begin(), rows.end(), kernel.id), 1)
        << "kernel '" << kernel.id << "' of kernel/sphere_triangle/kernels.cpp: " << behaviours_place
        << " should name it in one row; where what the kernel answers is what it should, that is\n"
        << row_text(kernel.id, heard_of<TypeParam>(kernel));
  }
  for (const std::string& row : rows) {
    EXPECT_EQ(std::count(ids.begin(), ids.end(), row), 1)
        << behaviours_place << ": row `" << row << "` is not of a kernel of kernel/sphere_triangle/kernels.cpp";
  }
}

TYPED_TEST(BehaviourTest, KernelsAnswerAsTheirRowsSay) {
  for_each_row([](const Kernel& kernel, const Behaviour& expected) {
    EXPECT_EQ(row_text(kernel.id, heard_of<TypeParam>(kernel)), row_text(kernel.id, expected)) << behaviours_place;
  });
}

TYPED_TEST(BehaviourTest, AFilterDecidesWhatIsFarFromTheBoundary) {
  for_each_row([](const Kernel& kernel, const Behaviour& expected) {
    if (expected.area != Says::declines) return;
    EXPECT_TRUE(ask(kernel, clear_separations<TypeParam>()).all(Verdict::separated)) << kernel.id;
    EXPECT_TRUE(ask(kernel, overlaps<TypeParam>()).all(Verdict::contact)) << kernel.id;
  });
}

TYPED_TEST(BehaviourTest, TouchingADegenerateTriangleIsContact) {
  for_each_row([](const Kernel& kernel, const Behaviour& expected) {
    for (const auto& touching : {collinear<TypeParam>(3), point<TypeParam>(3), repeated<TypeParam>(3)}) {
      const HeardAnswers heard = ask(kernel, touching);
      EXPECT_TRUE(expected.area == Says::wrong || heard.all(Verdict::contact) ||
                  (expected.area == Says::declines && heard.never_other(Verdict::contact)))
          << kernel.id;
    }
  });
}

TYPED_TEST(BehaviourTest, CentresAndRadiiThatAreNoNumbers) {
  constexpr TypeParam inf = std::numeric_limits<TypeParam>::infinity(),
                      nan = std::numeric_limits<TypeParam>::quiet_NaN();
  for_each_row([](const Kernel& kernel, const Behaviour& expected) {
    const Verdict blind = expected.nan == Says::invalid     ? Verdict::invalid
                          : expected.nan == Says::undecided ? Verdict::undecided
                                                            : Verdict::contact;
    EXPECT_TRUE(ask(kernel, with({nan}, 9, 13)).all(blind)) << kernel.id << ": centre or radius is NaN";
    EXPECT_TRUE(ask(kernel, with({inf}, 12, 13)).all(blind)) << kernel.id << ": infinite radius";
  });
}

TEST(BehaviourTable, ARowMayBeOfSeveralKernels) {
  const auto rows = testing_support::parsed_row(
      "| `x`, `y+z` | right | wrong | contact | varies | invalid | separated | undecided | declines |");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].kernel, "x");
  EXPECT_EQ(row_text(rows[1].kernel, rows[1].behaviour),
            "| `y+z` | right | wrong | contact | varies | invalid | separated | undecided | declines |");
}

TEST(BehaviourTable, ARowThatCannotBeReadIsNamed) {
  EXPECT_THROW(testing_support::parsed_row("| `x` | right |"), std::runtime_error);
  EXPECT_THROW(testing_support::parsed_row(
                   "| `x` | right | wrong | contact | varies | invalid | separated | undecided | right? |"),
               std::runtime_error);
}

}  // namespace
}  // namespace axiscert
