// The class of an input on the queries of every family: the enclosures never contradict exact arithmetic, and the
// families that are made to be of a class are of it.
#include "exact/sphere_triangle/measures/input_class.h"

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/families/family_testing.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

template <class Real>
class InputClassesOfFamilies : public testing::Test {};
TYPED_TEST_SUITE(InputClassesOfFamilies, Reals);

TYPED_TEST(InputClassesOfFamilies, AreTheSameWithAndWithoutTheFilter) {
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    for_each_query<TypeParam>(family->name, 2000 / TRIAL_DIVISOR, [&](const Query<TypeParam>& q, std::uint64_t) {
      if (!is_valid(q)) return;
      EXPECT_EQ(shape_classes(q), shape_classes(q, false));
    });
    if (testing::Test::HasFailure()) FAIL() << family->name;
  }
}

TYPED_TEST(InputClassesOfFamilies, AreWhatAFamilyIsMadeToBe) {
  using enum InputClass;
  const std::pair<const char*, InputClass> made[] = {{"repeated", repeated}, {"collinear", collinear}, {"tie", tie}};
  for (const auto& [family, which] : made) {
    for_each_query<TypeParam>(family, 400 / TRIAL_DIVISOR, [&](const Query<TypeParam>& q, std::uint64_t) {
      EXPECT_TRUE(input_classes(q, squared_distance(q)).contains(which)) << family;
    });
  }
  std::uint64_t slivers = 0, far_away = 0, past_the_window = 0;
  const auto count = [](std::uint64_t& n, const char* family, InputClass which) {
    for_each_query<TypeParam>(family, 400,
                              [&](const Query<TypeParam>& q, std::uint64_t) { n += shape_classes(q).contains(which); });
  };
  count(slivers, "sliver", sliver);
  count(far_away, "far", far);
  count(past_the_window, "scale", scale);
  EXPECT_GT(slivers, 200u);
  EXPECT_GT(far_away, 200u);
  EXPECT_GT(past_the_window, 300u);
}

}  // namespace
}  // namespace axiscert
