// Families of images of the moving sphere: exact answers do not differ between images, and those of a kernel that
// differ are counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/source.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {
namespace {

std::vector<const ImageGroup*> groups_of_moving_sphere() {
  std::vector<const ImageGroup*> groups = image_groups();
  std::erase_if(groups, [](const ImageGroup* group) { return &group->predicate() != &moving_sphere_predicate(); });
  return groups;
}

template <class Real>
class MovingImages : public testing::Test {};
using ImagedReals = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingImages, ImagedReals);

// The part in contact of an image in parts, or the first part; the depth is that of the query, relative to its scene.
struct ImageTruth {
  Truth truth;
  double depth;
};
template <class Real>
ImageTruth truth_of_image(const Family& family, std::uint64_t first, std::size_t parts) {
  const Oracles& oracles = oracles_of(moving_sphere_predicate());
  ImageTruth found{};
  for (std::size_t part = 0; part < parts; ++part) {
    const Numbers<Real> q = family.make<Real>(1, first + part);
    const Truth truth = oracles.truth(q);
    if (part == 0 || (truth.verdict == Verdict::contact && found.truth.verdict != Verdict::contact)) {
      found = {truth, oracles.depth(q).value()};
    } else if (truth.verdict == Verdict::contact) {
      found.truth.touching &= truth.touching;
    }
  }
  return found;
}

TYPED_TEST(MovingImages, HaveTheExactAnswersOfTheBase) {
  for (const ImageGroup* group : groups_of_moving_sphere()) {
    const Family& family = find_family(group->family);
    std::size_t contacts = 0;
    for (std::uint64_t base = 0; base < 24; ++base) {
      const std::uint64_t at = base * group->size;
      const ImageTruth own = truth_of_image<TypeParam>(family, at, 1);
      contacts += own.truth.verdict == Verdict::contact;
      for (std::size_t i = 1; i < group->size; i += group->parts) {
        const ImageTruth image = truth_of_image<TypeParam>(family, at + i, group->parts);
        if (group->kind(i) == ImageKind::halving) {  // it has more of the way, and another scene
          EXPECT_TRUE(image.truth.verdict == Verdict::contact || own.truth.verdict != Verdict::contact)
              << family.name << " at " << at + i;
          continue;
        }
        EXPECT_EQ(image.truth.verdict, own.truth.verdict) << family.name << " at " << at + i;
        if (group->parts > 1) continue;  // parts have scenes of their own
        EXPECT_EQ(image.truth.touching, own.truth.touching) << family.name << " at " << at + i;
        EXPECT_EQ(image.depth, own.depth) << family.name << " at " << at + i;
      }
    }
    EXPECT_TRUE(contacts > 0 && contacts < 24) << family.name;
  }
}

TYPED_TEST(MovingImages, GoingOnTwiceAsFarHalvesTheTimeExactly) {
  const Oracles& oracles = oracles_of(moving_sphere_predicate());
  const Family& family = find_family("moving-sphere/halved");
  std::size_t contacts = 0;
  for (std::uint64_t base = 0; base < 24; ++base) {
    const auto details = oracles.details(family.make<TypeParam>(1, 4 * base));
    const double* const time = std::get_if<double>(&details[0].value);
    if (time == nullptr) continue;
    ++contacts;
    for (const std::uint64_t i : {1, 2, 3}) {
      const auto going_on = oracles.details(family.make<TypeParam>(1, 4 * base + i));
      const double* const sooner = std::get_if<double>(&going_on[0].value);
      ASSERT_NE(sooner, nullptr) << 4 * base + i;
      EXPECT_EQ(*sooner, std::ldexp(*time, -static_cast<int>(i))) << 4 * base + i;
    }
  }
  EXPECT_GT(contacts, 4u);
}

TYPED_TEST(MovingImages, AreAllDifferentAndAsManyAsTheySay) {
  for (const ImageGroup* group : groups_of_moving_sphere()) {
    std::set<std::vector<TypeParam>> images;
    const Family& family = find_family(group->family);
    for (std::size_t i = 0; i < group->size; ++i) {
      const Numbers<TypeParam> q = family.make<TypeParam>(1, i);
      images.insert(std::vector<TypeParam>(q.begin(), q.end()));
    }
    EXPECT_EQ(images.size(), group->size) << group->family;
  }
}

Asymmetry counted_on(const Kernel& kernel, const char* family, std::uint64_t queries) {
  const SourcePtr source = family_source(find_family(family));
  return *asymmetry_of({*source, 1, Precision::binary32}, queries, kernel, nullptr, {std::string(scalar_target)});
}

// `twenty-nonstrict`, but separated on queries for which `is_wrong` holds.
template <class IsWrong>
Kernel nonstrict_but(const IsWrong& is_wrong) {
  Kernel kernel = find_kernel("moving-sphere/twenty-nonstrict");
  kernel.binary32 = [is_wrong](std::string_view target) {
    Implementation<float> right = find_kernel("moving-sphere/twenty-nonstrict").on<float>(target);
    return Implementation<float>{[=](const QueryColumns<float>& batch, Verdict* out) {
                                   right.verdicts(batch, out);
                                   for (std::size_t i = 0; i < batch.size; ++i) {
                                     if (is_wrong(batch, i)) out[i] = Verdict::separated;
                                   }
                                 },
                                 right.explain};
  };
  return kernel;
}

TEST(MovingAsymmetries, OfTheTwentyAxesAreThoseOfItsRoundings) {
  const Kernel& nonstrict = find_kernel("moving-sphere/twenty-nonstrict");
  EXPECT_GT(counted_on(nonstrict, "moving-sphere/orders", 3000).comparisons, 0u);
  for (const char* family : {"moving-sphere/inverted", "moving-sphere/units"}) {
    const Asymmetry found = counted_on(nonstrict, family, 3000);
    EXPECT_GT(found.images, 1000u) << family;
    EXPECT_EQ(found.verdicts + found.comparisons, 0u) << family;
  }
  // A motion's ends are compared in another order when it is turned round, and its parts have other numbers.
  const Asymmetry split = counted_on(nonstrict, "moving-sphere/split", 700);
  EXPECT_EQ(split.images, 300u);
  EXPECT_EQ(split.comparisons, 0u) << "those of a part are others than the whole's";
  EXPECT_EQ(split.invariance.kinds[ImageKind::split].images, 300u);
  // Contacts alone say something of a motion that goes on.
  const Asymmetry halved = counted_on(nonstrict, "moving-sphere/halved", 4000);
  EXPECT_GT(halved.images, 300u);
  EXPECT_LT(halved.images, 3000u);
  EXPECT_EQ(halved.comparisons, 0u) << "those of the end are others";
  EXPECT_EQ(halved.invariance.kinds[ImageKind::halving].images, halved.images);
}

TEST(MovingAsymmetries, AreFoundWhereAFaultIsPlanted) {
  const auto to_the_left =
      nonstrict_but([](const QueryColumns<float>& q, std::size_t i) { return q.column[12][i] < 0; });
  const auto far =
      nonstrict_but([](const QueryColumns<float>& q, std::size_t i) { return std::fabs(q.column[9][i]) > 0x1p19f; });
  const auto tiny = nonstrict_but([](const QueryColumns<float>& q, std::size_t i) { return q.column[15][i] < 1e-3f; });
  const auto slow = nonstrict_but([](const QueryColumns<float>& q, std::size_t i) {
    return std::fabs(q.column[12][i]) + std::fabs(q.column[13][i]) + std::fabs(q.column[14][i]) < 1e4f;
  });
  const auto fast = nonstrict_but([](const QueryColumns<float>& q, std::size_t i) {
    return std::fabs(q.column[12][i]) + std::fabs(q.column[13][i]) + std::fabs(q.column[14][i]) > 1e6f;
  });
  for (const char* family : {"moving-sphere/inverted", "moving-sphere/axes", "moving-sphere/reversed"}) {
    EXPECT_GT(counted_on(to_the_left, family, 960).verdicts, 0u) << family;
  }
  EXPECT_GT(counted_on(far, "moving-sphere/translated", 960).verdicts, 0u);
  EXPECT_GT(counted_on(slow, "moving-sphere/split", 1400).verdicts, 0u);
  EXPECT_GT(counted_on(fast, "moving-sphere/halved", 960).verdicts, 0u);
  const Asymmetry in_units = counted_on(tiny, "moving-sphere/units", 4000);
  EXPECT_GT(in_units.invariance.units.wrong.changed, 0u) << "a length of its own, on clear queries";
  EXPECT_FALSE(in_units.invariance.units.small.empty());
}

}  // namespace
}  // namespace axiscert
