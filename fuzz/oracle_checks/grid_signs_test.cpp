// Signs by integers on the queries of the families, compared with those of arbitrary precision.
#include "exact/sphere_triangle/filters/grid_signs.h"

#include "fuzz/families/family_testing.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

template <class Real>
void expect_exact() {
  constexpr int queries = 4096;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<Real>(family->name, queries, [&](const Query<Real>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      const Signs found = integer_signs(q), exact = signs_of(exact_sides(q));
      EXPECT_EQ(found.strict, exact.strict);
      EXPECT_EQ(found.ties, exact.ties);
    });
    if (testing::Test::HasFailure()) return;
  }
}
TEST(GridSignsOfFamilies, AreExactInBinary32) { expect_exact<float>(); }
TEST(GridSignsOfFamilies, AreExactInBinary64) { expect_exact<double>(); }

}  // namespace
}  // namespace axiscert
