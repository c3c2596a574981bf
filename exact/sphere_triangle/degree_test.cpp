// Degrees and bit lengths compared with computation by hand and with the results of exact evaluation.
#include "exact/sphere_triangle/degree.h"

#include <gtest/gtest.h>

#include <random>

#include "exact/numbers/floating.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {
namespace {

using enum Comparison;

const ComparisonDegree& degree(Formulae formulae, Comparison which) {
  static EnumArray<Formulae, std::optional<ComparisonDegrees>> found;
  auto& degrees = found[formulae];
  if (!degrees) degrees = degrees_of(formulae);
  return (*degrees)[which];
}

void expect_degree(Formulae formulae, Comparison which, std::optional<double> lhs, std::optional<double> rhs,
                   std::optional<BitLength> bits) {
  const ComparisonDegree& found = degree(formulae, which);
  EXPECT_EQ(found.lhs, lhs) << name(formulae) << " " << info(which).name;
  EXPECT_EQ(found.rhs, rhs) << name(formulae) << " " << info(which).name;
  EXPECT_EQ(found.bits, bits) << name(formulae) << " " << info(which).name;
}

// Translated vertices have b + 1 bits, edges b + 2, a dot product of x and y bits x + y + 2.
TEST(Degree, PublishedByHand) {
  expect_degree(Formulae::published, plane_radius, 6, 6, BitLength{6, 16});  // V: 2b+5, d: 3b+8
  for (const Comparison which : {vertex_a_radius, vertex_b_side_a, vertex_c_side_b}) {
    expect_degree(Formulae::published, which, 2, 2, BitLength{2, 4});
  }
  for (const Comparison which : {edge_ab_radius, edge_bc_radius, edge_ca_radius}) {
    expect_degree(Formulae::published, which, 6, 6, BitLength{6, 18});  // d1: 2b+5, e1: 2b+6, Q: 3b+8
  }
  for (const Comparison which : {edge_ab_side_c, edge_bc_side_a, edge_ca_side_b}) {
    expect_degree(Formulae::published, which, 6, std::nullopt, BitLength{6, 19});  // QC: 3b+9
  }
}

TEST(Degree, ReducedByHand) {
  expect_degree(Formulae::reduced, plane_radius, 6, 6, BitLength{6, 16});
  expect_degree(Formulae::reduced, edge_ab_radius, 4, 4, BitLength{4, 8});              // N = A x B: 2b+3
  expect_degree(Formulae::reduced, edge_ca_side_b, std::nullopt, 4, BitLength{4, 10});  // V: 2b+5
  expect_degree(Formulae::reduced_along, edge_ab_radius, 4, 4, BitLength{4, 10});       // N = A x AB: 2b+4
  expect_degree(Formulae::reduced_along, edge_ca_side_b, std::nullopt, 4, BitLength{4, 11});
}

TEST(Degree, TheFirstRungHasRootsAndDivisions) {
  expect_degree(Formulae::ladder_0, plane_radius, 1, 1, std::nullopt);
  expect_degree(Formulae::ladder_1, plane_radius, 2, 2, std::nullopt);
  expect_degree(Formulae::ladder_0, vertex_a_radius, 1, 1, std::nullopt);
  expect_degree(Formulae::ladder_0, vertex_a_side_b, 2, std::nullopt, BitLength{2, 5});
  expect_degree(Formulae::ladder_0, edge_ab_radius, 1, 1, std::nullopt);
  expect_degree(Formulae::ladder_6, edge_ab_radius, 6, 6, std::nullopt);
  // Two of the three branches on a segment end at a vertex, without a division; the third has one.
  expect_degree(Formulae::segments, edge_ab_radius, 2, 2, std::nullopt);
  EXPECT_FALSE(degrees_of(Formulae::closest_point)) << "a method has no comparisons";
}

Query<double> integers(std::mt19937_64& random, int bits) {
  std::array<double, coordinate_count> v;
  const auto greatest = static_cast<std::int64_t>((std::uint64_t{1} << bits) - 1);
  // Half of the numbers are the greatest of b bits, where the bound is tightest.
  for (double& x : v) x = static_cast<double>(random() % 2 ? greatest : static_cast<std::int64_t>(random()) % greatest);
  for (std::size_t k = 0; k < 12; ++k) v[k] *= random() % 2 ? 1 : -1;
  v[12] = std::abs(v[12]);
  return from_coordinates(v);
}

constexpr unsigned seed = 11;

constexpr EnumArray<Formulae, bool> are_rings = {
#define AXISCERT_RING(name, type, kind) type::is_ring,
    AXISCERT_FORMULAE(AXISCERT_RING)
#undef AXISCERT_RING
};

TEST(Degree, ExactSidesScaleByTheDegreeAndFitTheBits) {
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < formulae_count; ++i) {
    const auto formulae = static_cast<Formulae>(i);
    const auto degrees = degrees_of(formulae);
    if (!degrees) continue;
    for (int trial = 0; trial < 100; ++trial) {
      const int bits = 1 + trial % 20;
      const Query<double> q = integers(random, bits);
      auto doubled_coordinates = coordinates(q);
      for (double& x : doubled_coordinates) x *= 2;
      if (!are_rings[formulae]) break;  // the exact sides are not the emitted ones
      const ExactSides truth = exact_sides(formulae, q);
      const ExactSides doubled = exact_sides(formulae, from_coordinates(doubled_coordinates));
      for (std::size_t k = 0; k < comparison_count; ++k) {
        const ComparisonDegree& d = (*degrees)[k];
        const auto expect_side = [&](const BinaryNumber& side, const BinaryNumber& twice,
                                     std::optional<double> degree) {
          const Rational value = rational(side);
          EXPECT_EQ(rational(twice), value * (1 << static_cast<int>(degree.value_or(0))))
              << name(formulae) << " " << comparisons[k].name << ", seed " << seed << ", trial " << trial;
          if (value != 0) {
            EXPECT_LE(mpz_sizeinbase(value.get_num_mpz_t(), 2), static_cast<std::size_t>(d.bits.value().at(bits)))
                << name(formulae) << " " << comparisons[k].name << ", seed " << seed << ", trial " << trial;
          }
        };
        expect_side(truth.lhs[k].over, doubled.lhs[k].over, d.lhs);
        expect_side(truth.rhs[k].over, doubled.rhs[k].over, d.rhs);
      }
    }
  }
}

double value(const Floating& x) { return mpfr_get_d(x.get(), MPFR_RNDN); }

// Eight bits, the exponents of binary32: the least subnormal number is 2^-133, the greatest finite one 255 * 2^120.
TEST(Floating, LimitsTheExponentsAtAnyPrecision) {
  const FloatingScope scope({8, Rounding::nearest, Precision::binary32});
  const Floating zero(0.0);
  EXPECT_EQ(value(Floating(0x1p-149)), 0x1p-149) << "a number made from a double is that double";
  EXPECT_EQ(value(Floating(0x1p-149) + zero), 0);
  EXPECT_EQ(value(Floating(0x1p-134) + zero), 0) << "a tie goes to the even neighbour";
  EXPECT_EQ(value(Floating(0x1.8p-134) + zero), 0x1p-133);
  EXPECT_EQ(value(Floating(0x3p-134) + zero), 0x1p-132);
  EXPECT_EQ(value(Floating(0x1.00001p-134) + zero), 0x1p-133) << "rounded once: not to a tie of eight bits first";
  EXPECT_EQ(value(Floating(0x1.20001p-131) + zero), 0x1.4p-131);
  EXPECT_EQ(value(Floating(0xffp120) + zero), 0xffp120);
  EXPECT_EQ(value(Floating(0x1ffp119) + zero), std::numeric_limits<double>::infinity());
  EXPECT_EQ(value(Floating(0x1p-80) * Floating(0x1p-80)), 0);
}

}  // namespace
}  // namespace axiscert
