// Signs in few words on what the families make: those of CGAL::Mpzf, and nearly always there.
#include "exact/grid_signs.h"

#include "fuzz/family_testing.h"

namespace axiscert {
namespace {

// In `bits` nearly all numbers lie farther apart than any width reaches; in others some do.
double least_share(std::string_view family) {
  if (family == "bits") return 0;
  if (family == "on" || family == "nonfinite") return 0.5;
  return family == "sliver" ? 0.9 : 0.98;
}

template <class Real>
void expect_exact() {
  constexpr int queries = 4096;
  for (const Family* family : families()) {
    int valid = 0, decided = 0;
    for_each_query<Real>(family->name, queries, [&](const Query<Real>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      ++valid;
      const std::optional<Signs> found = grid_signs(q);
      if (!found) return;
      ++decided;
      const FormulaTruth truth = formula_truth(q);
      EXPECT_EQ(found->strict, truth.strict);
      EXPECT_EQ(found->ties, truth.ties);
    });
    if (testing::Test::HasFailure()) return;
    EXPECT_GE(decided, least_share(family->name) * valid) << family->name;
  }
}
TEST(GridSignsOfFamilies, AreExactInBinary32) { expect_exact<float>(); }
TEST(GridSignsOfFamilies, AreExactInBinary64) { expect_exact<double>(); }

}  // namespace
}  // namespace axiscert
