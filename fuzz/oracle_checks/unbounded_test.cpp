// R-infinity of binary32 on the processor equals MPFR's at 24 bits, for queries that leave the range and for queries
// that depend on roundings.
#include "exact/sphere_triangle/unbounded.h"

#include <cmath>
#include <limits>

#include "fuzz/queries/family_testing.h"
#include "fuzz/queries/random.h"

namespace axiscert {
namespace {

constexpr Formulae on_processor[] = {Formulae::published,           Formulae::reduced,
                                     Formulae::reduced_along,       Formulae::reduced_shared,
                                     Formulae::reduced_determinant, Formulae::ladder_9};

// Compares both strictnesses of each rung; ftz has the same R-infinity as plain arithmetic.
void expect_mpfr(const Query<float>& q, std::uint64_t i) {
  const Strictness strictness = i % 3 == 0 ? Strictness::nonstrict : Strictness::strict;
  const Formulae formulae = on_processor[i / 3 % std::size(on_processor)];
  const Outcome expected = at_precision(formulae, strictness, q, 24, std::nullopt);
  EXPECT_EQ(unbounded(formulae, Arithmetic::plain, strictness, q), expected) << name(formulae);
  EXPECT_EQ(unbounded(formulae, Arithmetic::ftz, strictness, q), expected) << name(formulae);
}

TEST(UnboundedBinary32, IsMpfrsOnFamilies) {
  for (const char* family : {"scale", "subnormal", "bits", "tangent", "sliver", "ratio", "collinear"}) {
    for_each_query<float>(family, 18 * 1000, [](const Query<float>& q, std::uint64_t i) { expect_mpfr(q, i); });
  }
}

// Numbers that are all of the greatest or all of the least magnitude use the range of binary64's exponents that the
// proof needs in full.
TEST(UnboundedBinary32, IsMpfrsAtTheEndsOfTheRange) {
  constexpr float greatest = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  Stream random(5, name_hash("ends of the range"), 1, Precision::binary32, 0);
  for (std::uint64_t i = 0; i < 18 * 1000; ++i) {
    std::array<float, coordinate_count> x;
    for (float& v : x) {
      const float size = random.below(4) == 0 ? random.unit<float>() : 1;
      const auto units = static_cast<float>(random.integer(-3, 3));
      const bool great = i % 3 == 0 || (i % 3 == 1 && random.coin());
      v = great ? (units < 0 ? -greatest : greatest) * size : least * units;
    }
    x[12] = std::fabs(x[12]);
    expect_mpfr(from_coordinates(x), i);
    ASSERT_FALSE(testing::Test::HasFailure()) << "query " << i;
  }
}

}  // namespace
}  // namespace axiscert
