// Numbers of a kernel's own: what was compared, and near which size; and kernels that have none.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "fuzz/diagnosis/changed_kernels_testing.h"
#include "fuzz/diagnosis/made_kernels_testing.h"
#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/scenes_by_trait.h"
#include "fuzz/text/json.h"
#include "kernel/names.h"

namespace axiscert::made {

// The published comparisons with both sides times |AB|^2, which makes them of degree 8: right, and soon out of range.
inline Kernel of_degree_8() {
  return kernel_of("degree-8", []<class Real>(const Query<Real>& q, const auto&) {
    static const Implementation<Real> published = find_kernel("published").on<Real>(scalar_target);
    const Real more = dot(q.b - q.a, q.b - q.a);
    if (more == 0) return right(q);
    const Reply<Real> sides = axiscert::ask(published, Numbers<Real>(q));
    ComparisonBits bits = 0;
    for (std::size_t k = 0; k < sides.answers.lhs.size(); ++k) {
      if (sides.answers.lhs[k][0] * more > sides.answers.rhs[k][0] * more) bits |= ComparisonBits{1} << k;
    }
    return verdict_of(sphere_triangle_predicate(), bits);
  });
}

// The foot of P lies in the face where three areas add up to that of the triangle, but for an epsilon.
inline Kernel by_sum_of_areas(double epsilon) {
  return kernel_of("sum-of-areas", [epsilon]<class Real>(const Query<Real>& q, const auto&) {
    const Vec3<Real> n = normal_of(q);
    const Real nn = dot(n, n);
    if (nn == 0) return right(q);
    const Vec3<Real> foot = q.p - n * (dot(q.p - q.a, n) / nn);
    const auto area = [](const Vec3<Real>& u, const Vec3<Real>& v) {
      const Vec3<Real> w = cross(u, v);
      return std::sqrt(dot(w, w)) / 2;
    };
    const Real sum = area(q.a - foot, q.b - foot) + area(q.b - foot, q.c - foot) + area(q.c - foot, q.a - foot);
    if (std::abs(sum - std::sqrt(nn) / 2) < static_cast<Real>(epsilon)) {
      const Vec3<Real> to = q.p - foot;
      return dot(to, to) <= q.r * q.r ? Verdict::contact : Verdict::separated;
    }
    const auto reaches = [&](const Vec3<Real>& from, const Vec3<Real>& to) {
      const Vec3<Real> edge = to - from, v = q.p - from;
      const Real t = std::clamp(dot(v, edge) / dot(edge, edge), Real(0), Real(1));
      const Vec3<Real> w = v - edge * t;
      return dot(w, w) <= q.r * q.r;
    };
    return reaches(q.a, q.b) || reaches(q.b, q.c) || reaches(q.c, q.a) ? Verdict::contact : Verdict::separated;
  });
}

// A motion below 1e-6 taken for none.
inline Kernel without_short_motions(const Kernel& base) {
  return answered_by(base, "short-motions", []<class Real>(const Kernel& of, const auto& right, Numbers<Real> query) {
    const std::size_t first = *diagnosis::first_column(of, "d");
    Real squared = 0;
    for (std::size_t k = first; k < first + 3; ++k) squared += query[k] * query[k];
    return verdict_by(right, squared < Real(1e-12) ? diagnosis::without_motion(of, query) : query);
  });
}

// A motion taken for parallel to the face, and so for none, where D . (AB x AC) is below 1e-12.
inline Kernel with_parallel_epsilon(const Kernel& base) {
  return answered_by(base, "parallel", []<class Real>(const Kernel& of, const auto& right, Numbers<Real> query) {
    const auto at = [&](const char* name) {
      const std::size_t k = *diagnosis::first_column(of, name);
      return Vec3<Real>{query[k], query[k + 1], query[k + 2]};
    };
    const Real determinant = dot(at("d"), cross(at("b") - at("a"), at("c") - at("a")));
    const bool is_parallel = std::abs(determinant) < Real(1e-12);
    return verdict_by(right, is_parallel ? diagnosis::without_motion(of, query) : query);
  });
}

}  // namespace axiscert::made

namespace axiscert {
namespace {

using testing::HasSubstr;
using namespace made;

TEST(ExactImages, AreNotMadeWhereANumberIsLost) {
  const std::vector<std::size_t> all = {0, 1};
  const float least = std::numeric_limits<float>::denorm_min();
  EXPECT_FALSE(diagnosis::times_exactly<float>({1, least}, all, -24));
  EXPECT_FALSE(diagnosis::times_exactly<float>({1, 0x1.8p-140f}, all, -9));
  EXPECT_FALSE(diagnosis::times_exactly<float>({0x1p120f, 1}, all, 8));
  const auto scaled = diagnosis::times_exactly<float>({1, least}, all, 24);
  ASSERT_TRUE(scaled);
  EXPECT_EQ((*scaled)[1], 0x1p-125f);
  EXPECT_TRUE(diagnosis::times_exactly<float>({0, -0.0f}, all, -149));
}

// A number that was compared with the quantity, within a factor of 2.
void expect_named(const Kernel& kernel, Precision precision, const std::string& quantity, double size,
                  const std::string& value = "present") {
  const diagnosis::ProbeFinding found = found_of(kernel, precision, "absolute_threshold");
  SCOPED_TRACE(fmt::format("{} in {}: {}: {} {}", kernel.id, name(precision), found.value, found.sentence,
                           found.measured.dump()));
  EXPECT_EQ(found.value, value);
  EXPECT_THAT(found.sentence, HasSubstr("What explains them best: " + quantity));
  const Json& compared = found.measured["compared"];
  EXPECT_TRUE(std::ranges::any_of(compared, [&](const Json& one) {
    return one["quantity"] == quantity && one["least"] >= size / 2 && one["greatest"] <= size * 2;
  }));
}

TEST(Thresholds, AreNamedWithTheirSize) {
  expect_named(by_sum_of_areas(1e-5), single, "FAB + FBC + FCA - ABC, of areas and the foot F of P", 1e-5);
}

TEST(ThresholdsLong, AreNamedWithTheirSizeInOtherPredicates) {
  const Kernel& moving = find_kernel("moving-sphere/twenty-nonstrict");
  expect_named(without_short_motions(moving), twice, "the motion |D|", 1e-6);
  expect_named(with_parallel_epsilon(moving), twice, "D . (AB x AC)", 1e-12);
  const std::string raised = "the half extent to which all that are less have to be raised for contact";
  expect_named(clamped(find_kernel("box-box/projected")), single, raised, 0.01);
  expect_named(clamped(find_kernel("box-triangle/thirteen")), twice, raised, 0.01);
  for (const Precision precision : {single, twice}) {
    expect_named(without_short_quaternions(find_kernel("box-box/cofactor-turned")), precision,
                 "the length of the quaternion", 1e-6, "quaternions");
  }
}

TEST(Thresholds, ShowOnBothSides) {
  const diagnosis::ProbeFinding found = found_of(by_sum_of_areas(1e-5), single, "absolute_threshold");
  EXPECT_THAT(found.sentence, testing::ContainsRegex("small: from 2\\^[-0-9]+ down, and large: from 2\\^[-0-9]+ up"));
  const diagnosis::ProbeFinding window = found_of(by_sum_of_areas(1e-5), single, "range_window");
  EXPECT_EQ(window.value, "limited");
  EXPECT_LE(window.measured["high"], 8) << window.sentence;
  EXPECT_THAT(window.sentence, HasSubstr("no formula of degree 8 or less leaves the range"));
}

TEST(ThresholdsLong, AreNoneWhereAFormOfDegree8LeavesItsRange) {
  for (const Precision precision : {single, twice}) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      const diagnosis::ProbeFinding found = found_of(of_degree_8(), precision, "absolute_threshold", seed);
      EXPECT_EQ(found.value, "none_found") << found.sentence << found.measured.dump();
    }
    const diagnosis::ProbeFinding window = found_of(of_degree_8(), precision, "range_window");
    EXPECT_EQ(window.value, "limited");
    EXPECT_EQ(window.measured["degree_high"], 8) << window.sentence;
    EXPECT_THAT(window.sentence, HasSubstr("differences of a query's numbers overflow to the power of 8."));
  }
}

bool has_a_number_of_its_own(const Kernel& kernel) {
  return kernel.id.find("physx") != std::string::npos || kernel.id.find("bullet") != std::string::npos;
}

void expect_none(std::uint64_t seed, const std::string& only = "") {
  for (const Kernel& kernel : kernels()) {
    if (has_a_number_of_its_own(kernel) || (!only.empty() && kernel.id != only)) continue;
    for (const Precision precision : {single, twice}) {
      if (!kernel.has(precision)) continue;
      const diagnosis::ProbeFinding found = found_of(kernel, precision, "absolute_threshold", seed);
      EXPECT_EQ(found.value, "none_found")
          << fmt::format("{} in {}, seed {}: {}", kernel.id, name(precision), seed, found.sentence);
    }
  }
}

TEST(Thresholds, AreNoneOfARightForm) { expect_none(1, "moving-sphere/walk"); }

TEST(ThresholdsLong, AreNoneOfTheBuiltInForms) {
  for (const std::uint64_t seed : {1, 2, 3}) expect_none(seed);
}

// A right kernel agrees with each form where that is right, and shares no error.
TEST(NearestForm, HasToShareItsErrors) {
  const diagnosis::ProbeFinding right = found_of(find_kernel("certified"), single, "nearest_form");
  EXPECT_EQ(right.value, not_known);
  EXPECT_THAT(right.sentence, HasSubstr("It is right on all"));
  const diagnosis::ProbeFinding same = found_of(find_kernel("published"), single, "nearest_form");
  EXPECT_EQ(same.value, "published");
  EXPECT_GE(same.measured["both_wrong"], 16);
  EXPECT_EQ(same.measured["form_wrong"], 0);
  // Right where the form errs, but for a ninth of these.
  const Kernel rarely = kernel_of("rarely-published", []<class Real>(const Query<Real>& q, const auto& place) {
    static const Implementation<Real> certified = find_kernel("certified").on<Real>(scalar_target);
    return place.position % 9 == 0 ? by_reference(Formulae::published, q)
                                   : axiscert::ask(certified, Numbers<Real>(q)).verdicts[0];
  });
  EXPECT_EQ(found_of(rarely, single, "nearest_form").value, not_known);
}

}  // namespace
}  // namespace axiscert
