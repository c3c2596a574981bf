// The clear families of boxes make what they claim: by exact arithmetic the axis in turn decides, alone; and what they
// are for is wrong on many of their clear queries, while right formulae are right on all.
#include <gtest/gtest.h>

#include <array>

#include "exact/boxes/measures.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/boxes/thirteen.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {
namespace {

template <class Real>
class ClearFamilies : public testing::Test {};
using ClearPrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(ClearFamilies, ClearPrecisions);

template <class Test, class Real>
auto query_in_doubles(const Numbers<Real>& q) {
  return Test::template problem<double>([&](std::size_t k) { return static_cast<double>(q[k]); });
}

// Three rounds of four are clear; the third of these is in contact. Exactly one axis decides, the one in turn.
template <class Test, class Real, class Exact>
void expect_each_axis_alone(const char* name, std::span<const std::string_view> axes, const Exact& exactly) {
  const Family& family = find_family(name);
  std::size_t others = 0, asked = 0;
  for (std::uint64_t position = 0; position < 4 * axes.size(); ++position) {
    if (position / axes.size() % 4 == 3) continue;
    const auto deciding = deciding_axes(exactly(query_in_doubles<Test>(family.make<Real>(3, position))));
    others += deciding != std::vector{axes[position % axes.size()]};
    ++asked;
  }
  EXPECT_EQ(others, 0u) << name << ": of " << asked << " queries at seed 3 another axis than that in turn decides";
}

TYPED_TEST(ClearFamilies, OfOneAxisAreDecidedByEachInTurn) {
  const auto pair = [](const auto& q) { return exact_pair(q); };
  const auto triangle = [](const auto& q) { return exact_box_and_triangle(q); };
  expect_each_axis_alone<MatrixBoxes, TypeParam>("box-box/one_axis", axis_names, pair);
  expect_each_axis_alone<QuaternionBoxes, TypeParam>("box-box/one_axis_turned", axis_names, pair);
  expect_each_axis_alone<MixedBoxes, TypeParam>("box-box/one_axis_mixed", axis_names, pair);
  expect_each_axis_alone<CentreEntry, TypeParam>("box-triangle/one_axis", thirteen_names, triangle);
  expect_each_axis_alone<MinmaxEntry, TypeParam>("box-triangle/one_axis_minmax", thirteen_names, triangle);
  expect_each_axis_alone<OrientedEntry, TypeParam>("box-triangle/one_axis_oriented", thirteen_names, triangle);
  expect_each_axis_alone<TurnedEntry, TypeParam>("box-triangle/one_axis_turned", thirteen_names, triangle);
}

template <std::size_t methods>
struct WrongOnClear {
  std::uint64_t clear = 0;
  std::array<std::uint64_t, methods> wrong{};
};
// How often each of the methods of separated(problem) differs from the clear verdict.
template <class Test, class Real, std::size_t methods, class Separated>
WrongOnClear<methods> wrong_on_clear(const char* name, std::uint64_t queries, const Separated& separated) {
  const Family& family = find_family(name);
  const Oracles& oracles = oracles_of(family.predicate(), family.entry);
  WrongOnClear<methods> found;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<Real> q = family.make<Real>(3, position);
    const std::optional<Verdict> clear = oracles.clear_verdict(q);
    if (!clear) continue;
    ++found.clear;
    const std::array<bool, methods> said = separated(Test::template problem<Real>([&](std::size_t k) { return q[k]; }));
    for (std::size_t k = 0; k < methods; ++k) found.wrong[k] += said[k] != (*clear == Verdict::separated);
  }
  return found;
}

template <class F, class Real, class Problem>
ComparisonBits separating(const Problem& problem) {
  return bits_of<F, Real>(problem, [](std::size_t, Real, Real) {});
}

// All axes, and all but each in turn.
template <class Test, class F, class Real, std::size_t axes>
void expect_dropped_axes_seen(const char* name) {
  const std::uint64_t queries = 60 * axes;
  const auto found = wrong_on_clear<Test, Real, axes + 1>(name, queries, [](const auto& problem) {
    const ComparisonBits bits = separating<F, Real>(problem);
    std::array<bool, axes + 1> said{};
    for (std::size_t axis = 0; axis < axes; ++axis) said[axis] = (bits & ~one_bit<ComparisonBits>(axis)) != 0;
    said[axes] = bits != 0;
    return said;
  });
  EXPECT_GT(found.clear, queries * 3 / 4) << name;
  EXPECT_EQ(found.wrong[axes], 0u) << name << ": with all axes";
  for (std::size_t axis = 0; axis < axes; ++axis) EXPECT_GT(found.wrong[axis], 15u) << name << " without axis " << axis;
}
TYPED_TEST(ClearFamilies, OfOneAxisSeeEachThatIsLeftOut) {
  expect_dropped_axes_seen<MatrixBoxes, Cofactor, TypeParam, axis_count>("box-box/one_axis");
  expect_dropped_axes_seen<QuaternionBoxes, Homogeneous, TypeParam, axis_count>("box-box/one_axis_turned");
  expect_dropped_axes_seen<MixedBoxes, ByMatrices<Cofactor>, TypeParam, axis_count>("box-box/one_axis_mixed");
  expect_dropped_axes_seen<CentreEntry, TextbookThirteen, TypeParam, thirteen_count>("box-triangle/one_axis");
  expect_dropped_axes_seen<MinmaxEntry, TextbookThirteen, TypeParam, thirteen_count>("box-triangle/one_axis_minmax");
  expect_dropped_axes_seen<OrientedEntry, FramedThirteen, TypeParam, thirteen_count>("box-triangle/one_axis_oriented");
  expect_dropped_axes_seen<TurnedEntry, TurnedThirteen, TypeParam, thirteen_count>("box-triangle/one_axis_turned");
}

// Boxes along the axes have three of them, each under several names.
TYPED_TEST(ClearFamilies, OfUprightBoxesSeeEachAxisThatIsLeftOut) {
  const auto found =
      wrong_on_clear<MinmaxBoxes, TypeParam, 4>("box-box/one_axis_minmax", 600, [](const CornersPair<TypeParam>& q) {
        const ComparisonBits bits = separating<Intervals, TypeParam>(q);
        const auto without = [&](std::size_t k) { return (bits & 7 & ~one_bit<ComparisonBits>(k)) != 0; };
        return std::array{without(0), without(1), without(2), bits != 0};
      });
  EXPECT_GT(found.clear, 450u);
  EXPECT_EQ(found.wrong[3], 0u) << "with all axes";
  for (std::size_t k = 0; k < 3; ++k) EXPECT_GT(found.wrong[k], 60u) << "without axis " << k;
}

// Products of edges are left out where |a_i.b_j| is within 1e-3 of 1; or 1e-4 is added to it.
template <class Real>
ComparisonBits with_skipped_products(const BoxPair<Real>& q, Real skipped, Real added) {
  ComparisonBits bits = 0;
  const Relative<Real> r = relative(q);
  const auto sink = [&](std::size_t i, Real lhs, Real rhs) {
    if (i >= 6 && std::fabs(r.turn[(i - 6) / 3][(i - 6) % 3]) > 1 - skipped) return;
    if (lhs > rhs) bits |= one_bit<ComparisonBits>(i);
  };
  const Matrix<Real> size = magnitudes(r.turn), raised = magnitudes(r.turn, &added);
  facets_of_a(r, size, sink);
  facets_of_b(r, r.half_b, size, sink);
  edge_axes(r, raised, magnitudes(cofactors(r.turn)), sink);
  return bits;
}
TYPED_TEST(ClearFamilies, OfAlignedBoxesSeeSkippedProductsAndEpsilons) {
  using Real = TypeParam;
  const auto found = wrong_on_clear<MatrixBoxes, Real, 5>("box-box/aligned", 1200, [](const BoxPair<Real>& q) {
    const auto said = [&](double skipped, double added) {
      return with_skipped_products(q, static_cast<Real>(skipped), static_cast<Real>(added)) != 0;
    };
    return std::array{said(0, 0), said(1e-3, 0), said(1e-5, 0), said(0, 1e-3), said(0, 1e-5)};
  });
  EXPECT_EQ(found.wrong[0], 0u) << "of " << found.clear << " clear";
  EXPECT_GT(found.wrong[1], 40u) << "skipped from 1 - 1e-3 on";
  EXPECT_GT(found.wrong[2], 10u) << "skipped from 1 - 1e-5 on";
  EXPECT_GT(found.wrong[3], 40u) << "1e-3 added";
  EXPECT_GT(found.wrong[4], sizeof(Real) == 4 ? 0u : 10u) << "1e-5 added";
}

template <class Real>
BoxPair<Real> with_least_extents(BoxPair<Real> q, Real least) {
  for (auto* box : {&q.a, &q.b}) {
    for (Real& s : box->half) s = std::max(s, least);
  }
  return q;
}
TYPED_TEST(ClearFamilies, OfSpansAndPlatesSeeExtentsThatAreClamped) {
  using Real = TypeParam;
  for (const char* name : {"box-box/spans", "box-box/plates"}) {
    const auto found = wrong_on_clear<MatrixBoxes, Real, 2>(name, 800, [](const BoxPair<Real>& q) {
      return std::array{separating<ProjectedFifteen, Real>(q) != 0,
                        separating<ProjectedFifteen, Real>(with_least_extents(q, Real(0.25))) != 0};
    });
    EXPECT_EQ(found.wrong[0], 0u) << name;
    EXPECT_GT(found.wrong[1], 40u) << name << ", of " << found.clear << " clear";
  }
}

// Quaternions below a length, or with a vector part below a part of w, taken for the identity.
template <class Real>
TurnedPair<Real> with_identity(TurnedPair<Real> q, Real least_square, Real least_part) {
  for (auto* box : {&q.a, &q.b}) {
    const auto [w, x, y, z] = box->q;
    const Real part = x * x + y * y + z * z;
    if (w * w + part < least_square || part < least_part * least_part * w * w) box->q = {1, 0, 0, 0};
  }
  return q;
}
TYPED_TEST(ClearFamilies, OfQuaternionsSeeThoseThatAreTakenForTheIdentity) {
  using Real = TypeParam;
  const auto wrong_with = [](const char* name, double one, double other, bool is_part) {
    const auto found = wrong_on_clear<QuaternionBoxes, Real, 3>(name, 600, [=](const TurnedPair<Real>& q) {
      const auto said = [&](double least) {
        const auto part = static_cast<Real>(is_part ? least : 0), square = static_cast<Real>(is_part ? 0 : least);
        return separating<ByMatrices<ProjectedFifteen>, Real>(with_identity(q, square, part)) != 0;
      };
      return std::array{said(0), said(one), said(other)};
    });
    EXPECT_EQ(found.wrong[0], 0u) << name << ", of " << found.clear << " clear";
    return found.wrong;
  };
  const auto of_lengths = wrong_with("box-box/lengths_turned", 1e-6, 1e-12, false);
  EXPECT_GT(of_lengths[1], 60u);
  EXPECT_GT(of_lengths[2], 10u);
  const auto of_parts = wrong_with("box-box/slight_turned", 1e-3, 1e-6, true);
  EXPECT_GT(of_parts[1], 60u);
  EXPECT_GE(of_parts[2], sizeof(Real) == 4 ? 0u : 60u);
}

// The verdict of the definition is that of the base in every unit of length.
template <class Test, class F, class Real>
void expect_one_verdict_in_all_units(const char* name) {
  const Family& family = find_family(name);
  const ImageGroup* group = image_group(name);
  ASSERT_NE(group, nullptr) << name;
  std::uint64_t contacts = 0, groups = 60;
  for (std::uint64_t base = 0; base < groups; ++base) {
    const auto verdict = [&](std::uint64_t image) {
      const Numbers<Real> q = family.make<Real>(3, base * group->size + image);
      return separating<F, Real>(Test::template problem<Real>([&](std::size_t k) { return q[k]; }));
    };
    contacts += verdict(0) == 0;
    for (std::uint64_t image = 1; image < group->size; ++image) EXPECT_EQ(verdict(image), verdict(0)) << name;
  }
  EXPECT_TRUE(contacts > groups / 5 && contacts < groups) << name << ' ' << contacts;
}
TYPED_TEST(ClearFamilies, OfUnitsKeepTheirVerdicts) {
  expect_one_verdict_in_all_units<MatrixBoxes, Textbook, TypeParam>("box-box/units");
  expect_one_verdict_in_all_units<QuaternionBoxes, Homogeneous, TypeParam>("box-box/units_turned");
  expect_one_verdict_in_all_units<CentreEntry, TextbookThirteen, TypeParam>("box-triangle/units");
  expect_one_verdict_in_all_units<MinmaxEntry, TextbookThirteen, TypeParam>("box-triangle/units_minmax");
  expect_one_verdict_in_all_units<OrientedEntry, FramedThirteen, TypeParam>("box-triangle/units_oriented");
  expect_one_verdict_in_all_units<MinmaxBoxes, Intervals, TypeParam>("box-box/units_minmax");
  expect_one_verdict_in_all_units<MixedBoxes, ByMatrices<Textbook>, TypeParam>("box-box/units_mixed");
  expect_one_verdict_in_all_units<TurnedEntry, TurnedThirteen, TypeParam>("box-triangle/units_turned");
}

}  // namespace
}  // namespace axiscert::boxes
