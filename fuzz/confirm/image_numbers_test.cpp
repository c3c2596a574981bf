// Numbers beside the verdicts on images: those of right kernels follow, and planted ones that do not are found.
#include "fuzz/confirm/image_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fuzz/confirm/asymmetry.h"
#include "fuzz/queries/family.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

constexpr const char* image_families[] = {"orders", "axes", "inverted", "scaled", "translated", "units"};

// The kernel with these numbers changed: a function of the columns, the query's number and its measures.
template <class Change>
Kernel with_numbers(const char* id, const Change& change) {
  Kernel kernel = find_kernel(id);
  const auto own = kernel.binary64;
  kernel.binary64 = [own, change](std::string_view target) {
    Implementation<double> made = own(target);
    const auto right = made.measure;
    made.measure = [right, change](const QueryColumns<double>& batch, Answers<double>& out) {
      right(batch, out);
      for (std::size_t i = 0; i < batch.size; ++i) {
        std::vector<double> numbers(out.measures.size());
        for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = out.measures[k][i];
        change(batch, i, numbers);
        for (std::size_t k = 0; k < numbers.size(); ++k) out.measures[k][i] = numbers[k];
      }
    };
    return made;
  };
  return kernel;
}

ImageNumbers numbers_on(const Kernel& kernel, const char* family, std::uint64_t queries = 2400) {
  const SourcePtr source = family_source(find_family(family));
  const SeededSource of{*source, 1, Precision::binary64};
  return asymmetry_of(of, queries, kernel, nullptr, {resolve_target("auto")})->numbers;
}

TEST(ImageNumbers, OfARightKernelFollowItsImages) {
  for (const char* family : image_families) {
    const ImageNumbers found = numbers_on(find_kernel("contact"), family);
    EXPECT_GT(found.separation.compared, 1000u) << family;
    EXPECT_GT(found.angle.compared, 500u) << family;
    EXPECT_GT(found.compared_features, 1000u) << family;
    EXPECT_EQ(found.features, 0u) << family;
    EXPECT_EQ(found.lost, 0u) << family;
    EXPECT_EQ(found.compared, found.images) << family;
    EXPECT_LT(found.separation.size, 0x1p-44) << family;
    EXPECT_LT(found.angle.size, 0x1p-44) << family;
    EXPECT_LT(found.point.size, 0x1p-44) << family;
  }
}

// Several directions part boxes that are alike, and several points of a face are right: any of them follows.
TEST(ImageNumbers, OfBoxesFollowThoughSeveralAreRight) {
  for (const char* family : {"box-box/symmetric", "box-box/units"}) {
    const ImageNumbers found = numbers_on(find_kernel("box-box/cofactor"), family, 1200);
    EXPECT_GT(found.angle.compared, 100u) << family;
    EXPECT_LT(found.separation.size, 0x1p-40) << family;
    EXPECT_EQ(found.lost, 0u) << family;
    EXPECT_LT(found.angle.size, 0x1p-20) << family;
    EXPECT_LT(found.point.size, 0x1p-30) << family;
  }
}

TEST(ImageNumbers, ANormalOfOneSideDoesNotFollowAMirror) {
  const auto upwards = [](const QueryColumns<double>&, std::size_t, std::vector<double>& m) {
    const bool is_down = m[4] < 0;
    for (std::size_t k = 2; is_down && k < 5; ++k) m[k] = -m[k];
  };
  const ImageNumbers found = numbers_on(with_numbers("contact", upwards), "axes");
  EXPECT_NEAR(found.angle.size, std::numbers::pi, 1e-3);
  ASSERT_TRUE(found.angle.pair);
  EXPECT_LT(found.point.size, 0x1p-44);
}

TEST(ImageNumbers, ANormalOfAnyLengthHasItsAngle) {
  for (const double length : {1.0, 1e200, 1e-200}) {
    const auto fixed = [length](const QueryColumns<double>&, std::size_t, std::vector<double>& m) {
      m[2] = 0.3 * length;
      m[3] = 0.5 * length;
      m[4] = 0.7 * length;
    };
    EXPECT_GT(numbers_on(with_numbers("contact", fixed), "axes", 600).angle.size, 1) << length;
  }
}

TEST(ImageNumbers, APointFromTheOriginDoesNotFollowATranslation) {
  const auto rounded = [](const QueryColumns<double>&, std::size_t, std::vector<double>& m) {
    m[5] = std::round(m[5] * 64) / 64;
  };
  const ImageNumbers found = numbers_on(with_numbers("contact", rounded), "axes");
  EXPECT_GT(found.point.size, 1e-4);
  EXPECT_LT(found.angle.size, 0x1p-44);
}

TEST(ImageNumbers, ASeparationOfTheFirstVertexAndAFeatureDoNotFollowAnOrder) {
  const auto lopsided = [](const QueryColumns<double>& q, std::size_t i, std::vector<double>& m) {
    m[0] =
        std::hypot(q.column[9][i] - q.column[0][i], q.column[10][i] - q.column[1][i], q.column[11][i] - q.column[2][i]);
    m[1] = 0;
  };
  const ImageNumbers found = numbers_on(with_numbers("contact", lopsided), "orders");
  EXPECT_GT(found.separation.size, 1e-3);
  EXPECT_GT(found.features, 100u);
  ASSERT_TRUE(found.first_feature);
}

TEST(ImageNumbers, ThatAreNotGivenAreNotCompared) {
  const auto none = [](const QueryColumns<double>&, std::size_t, std::vector<double>& m) {
    for (std::size_t k = 1; k < m.size(); ++k) m[k] = NAN;
  };
  const ImageNumbers found = numbers_on(with_numbers("contact", none), "orders");
  EXPECT_GT(found.separation.compared, 0u);
  EXPECT_EQ(found.angle.compared, 0u);
  EXPECT_EQ(found.compared_features, 0u);
  const AsymmetryRecord record = asymmetry_record(
      *asymmetry_of({*family_source(find_family("orders")), 1, Precision::binary64}, 600, with_numbers("contact", none),
                    nullptr, {resolve_target("auto")}),
      [](std::uint64_t position) { return std::to_string(position); }, true);
  EXPECT_TRUE(record.numbers->largest_separation);
  EXPECT_FALSE(record.numbers->largest_angle);
  EXPECT_FALSE(record.numbers->features);
}

TEST(ImageNumbers, ThatOneOfTheTwoLacksAreLost) {
  // The number of a query decides: an image and its base have different ones.
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{5}}) {
    const auto forgets = [which](const QueryColumns<double>&, std::size_t i, std::vector<double>& m) {
      if (i % 2 == 1) m[which] = which == 0 ? INFINITY : NAN;
    };
    const ImageNumbers found = numbers_on(with_numbers("contact", forgets), "orders", 600);
    EXPECT_GT(found.lost, 100u) << which;
    EXPECT_TRUE(found.first_lost) << which;
  }
  const auto zero = [](const QueryColumns<double>&, std::size_t i, std::vector<double>& m) {
    for (std::size_t k = 2; i % 2 == 1 && k < 5; ++k) m[k] = 0;
  };
  EXPECT_GT(numbers_on(with_numbers("contact", zero), "orders", 600).lost, 100u) << "a normal of length 0";
}

// The normal of a first contact, too, is compared where it differs.
TEST(ImageNumbers, OfFirstContactsAreComparedWhereTheyDiffer) {
  const auto turned = [](const QueryColumns<double>&, std::size_t i, std::vector<double>& m) {
    if (i % 2 == 1) std::swap(m[2], m[3]);
  };
  const ImageNumbers found = numbers_on(with_numbers("moving-sphere/rounded", turned), "moving-sphere/orders", 1200);
  EXPECT_GT(found.angle.size, 1e-3);
}

TEST(ImageNumbers, OfAKernelThatGivesNoneAreNotCounted) {
  const auto none = [](const QueryColumns<double>&, std::size_t, std::vector<double>& m) { std::ranges::fill(m, NAN); };
  const ImageNumbers found = numbers_on(with_numbers("contact", none), "orders", 600);
  EXPECT_GT(found.images, 0u);
  EXPECT_EQ(found.compared, 0u);
  EXPECT_EQ(found.lost, 0u);
}

// The exchange of two boxes turns the normal round and exchanges the points; a half turn leaves all as they are.
TEST(ImageNumbers, BoxesOfWhichOneIsAlwaysTheFirstDoNotFollowAnExchange) {
  const auto one_sided = [](const QueryColumns<double>&, std::size_t, std::vector<double>& m) {
    const bool is_down = m[1] < 0;
    for (std::size_t k = 1; is_down && k < 4; ++k) m[k] = -m[k];
  };
  EXPECT_NEAR(numbers_on(with_numbers("box-box/cofactor", one_sided), "box-box/symmetric", 400).angle.size,
              std::numbers::pi, 1e-3);
}

}  // namespace
}  // namespace axiscert
