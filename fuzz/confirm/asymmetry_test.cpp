// Answers that change with an image: a planted absolute number is found, by kind, power and size; a right kernel is
// not.
#include "fuzz/confirm/asymmetry.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/text/json_form.h"
#include "kernel/boxes/projected.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

using Columns = QueryColumns<double>;

// The certified kernel's verdicts, and another answer where `instead` has one. It is right everywhere, and shows
// verdicts alone.
template <class Instead>
Kernel right_but(const Instead& instead) {
  Kernel kernel = find_kernel("certified");
  kernel.binary32 = nullptr;
  kernel.exposes = Exposure::verdict;
  kernel.binary64 = [instead](std::string_view target) {
    const auto right = find_kernel("certified").on<double>(target).verdicts;
    return Implementation<double>{[=](const Columns& batch, Verdict* out) {
      right(batch, out);
      for (std::size_t i = 0; i < batch.size; ++i) out[i] = instead(batch, i, out[i]);
    }};
  };
  return kernel;
}
Kernel right() {
  return right_but([](const Columns&, std::size_t, Verdict verdict) { return verdict; });
}
// Spheres of less than this radius touch nothing.
Kernel without_small(double least) {
  return right_but([least](const Columns& q, std::size_t i, Verdict verdict) {
    return q.column[12][i] < least ? Verdict::separated : verdict;
  });
}

struct InvarianceFinding {
  Invariance invariance;
  Json json;
  AsymmetryRecord asymmetry;
};
InvarianceFinding found(const Kernel& kernel, const char* family, std::uint64_t queries) {
  const SourcePtr source = family_source(find_family(family));
  const SeededSource of{*source, 1, Precision::binary64};
  const Asymmetry asymmetry = *asymmetry_of(of, queries, kernel, nullptr, {resolve_target("auto")});
  const auto sizes = [&](std::span<const UnitFlip> flips) { return absolute_sizes(of, flips); };
  const auto address = [](std::uint64_t position) { return std::to_string(position); };
  return {asymmetry.invariance,
          json_of(invariance_record(asymmetry.invariance, *image_group(family), Precision::binary64, address, sizes)),
          asymmetry_record(asymmetry, address, false)};
}

TEST(Invariance, OfARightKernelIsWhole) {
  for (const char* family : {"orders", "axes", "inverted", "scaled", "translated", "units", "spans"}) {
    for (const ImageChanges& changes : found(right(), family, 2400).invariance.kinds) {
      EXPECT_EQ(changes.changed, 0u) << family;
      EXPECT_FALSE(changes.first) << family;
    }
  }
}

TEST(Invariance, AnAbsoluteNumberIsFoundWithItsSizeInEitherDirection) {
  for (const double size : {1e-6, 1e-20}) {
    for (const char* family : {"units", "spans"}) {
      const InvarianceFinding small = found(without_small(size), family, 9600);
      const ImageChanges& wrong = small.invariance.units.wrong;
      ASSERT_GT(wrong.changed, 100u) << family;
      EXPECT_TRUE(small.invariance.units.large.empty()) << family;
      // r is at least a half, or 0, and so about 1 at the greatest power that shows it; not every base is asked times
      // every power.
      EXPECT_NEAR(wrong.by_size.rbegin()->first, std::log2(size), 4) << family;
      const Json& compared = small.json["scale"]["wrong"]["where_small"]["compared"][0];
      EXPECT_EQ(compared["quantity"], "r");
      EXPECT_LE(compared["least"].get<double>(), size);
      EXPECT_GE(compared["greatest"].get<double>(), size * 0.999);
      EXPECT_LT(compared["greatest"].get<double>(), compared["least"].get<double>() * 1.5);
      // The first pair is one of them: the power nearest to 1 that shows it.
      const ImageGroup& group = *image_group(family);
      ASSERT_TRUE(wrong.first);
      EXPECT_EQ(wrong.first->base % group.size, 0u);
      EXPECT_EQ(
          group.exponent(Precision::binary64, wrong.first->base / group.size, wrong.first->image - wrong.first->base),
          wrong.by_size.rbegin()->first);
    }
  }
  const Kernel large = right_but([](const Columns& q, std::size_t i, Verdict verdict) {
    return q.column[12][i] > 1e9 ? Verdict::separated : verdict;
  });
  const InvarianceFinding found_large = found(large, "spans", 9600);
  EXPECT_TRUE(found_large.invariance.units.small.empty());
  EXPECT_EQ(found_large.json["scale"]["wrong"]["where_large"]["compared"][0]["quantity"], "r");
  EXPECT_NEAR(found_large.json["scale"]["wrong"]["where_large"]["compared"][0]["least"].get<double>(), 1e9, 5e8);
}

// In every entry, and where axes and quaternions have no length.
TEST(Invariance, AClampOfHalfExtentsIsFoundInEveryEntry) {
  struct Entry {
    const char *right, *family;
    bool is_of_corners;
    std::vector<std::size_t> first_half;
  };
  const Entry entries[] = {{"box-box/textbook", "box-box/units", false, {3, 18}},
                           {"box-box/homogeneous", "box-box/units_turned", false, {3, 13}},
                           {"box-triangle/thirteen-minmax", "box-triangle/units_minmax", true, {0}},
                           {"box-triangle/thirteen-oriented", "box-triangle/units_oriented", false, {3}}};
  for (const Entry& entry : entries) {
    SCOPED_TRACE(entry.family);
    Kernel kernel = find_kernel(entry.right);
    kernel.exposes = Exposure::verdict;
    kernel.binary64 = [entry](std::string_view target) {
      const auto right = find_kernel(entry.right).on<double>(target).verdicts;
      return Implementation<double>{[=](const Columns& batch, Verdict* out) {
        QueryBatch<double> clamped(batch.size, batch.count);
        for (std::size_t i = 0; i < batch.size; ++i) {
          Numbers<double> q(batch.count);
          for (std::size_t k = 0; k < batch.count; ++k) q[k] = batch.column[k][i];
          for (const std::size_t first : entry.first_half) {
            for (std::size_t k = first; k < first + 3; ++k) {
              if (entry.is_of_corners && q[k + 3] - q[k] < 0.02) {
                const double middle = (q[k] + q[k + 3]) / 2;
                q[k] = middle - 0.01;
                q[k + 3] = middle + 0.01;
              }
              if (!entry.is_of_corners) q[k] = std::max(q[k], 0.01);
            }
          }
          clamped.push_back(q);
        }
        right(clamped.columns(), out);
      }};
    };
    const InvarianceFinding clamped = found(kernel, entry.family, 2400);
    EXPECT_GT(clamped.invariance.units.small.size(), 8u);
    const Json& compared = clamped.json["scale"]["wrong"]["where_small"]["compared"];
    ASSERT_FALSE(compared.empty());
    EXPECT_EQ(compared[0]["quantity"], "the half extent to which all that are less have to be raised for contact");
    EXPECT_NEAR(compared[0]["least"].get<double>(), 0.01, 0.002);
  }
}

// Products of edges that are left out where the half edges' own product is small.
TEST(Invariance, ALengthOfTheProductThatPartsIsFound) {
  Kernel kernel = find_kernel("box-box/projected");
  kernel.exposes = Exposure::verdict;
  kernel.binary64 = [](std::string_view) {
    return Implementation<double>{[](const Columns& batch, Verdict* out) {
      for (std::size_t n = 0; n < batch.size; ++n) {
        const auto q = boxes::MatrixBoxes::problem<double>([&](std::size_t k) { return batch.column[k][n]; });
        bool is_apart = false;
        const auto see = [&](std::size_t i, double lhs, double rhs) {
          const auto along = boxes::direction(q, i);
          const double half = i < 6 ? 1 : q.a.half[(i - 6) / 3] * q.b.half[(i - 6) % 3];
          is_apart |= lhs > rhs && (i < 6 || std::sqrt(dot(along, along)) * half >= 1e-3);
        };
        boxes::ProjectedFifteen::comparisons<double>(q, see);
        out[n] = is_apart ? Verdict::separated : Verdict::contact;
      }
    }};
  };
  const Json compared = found(kernel, "box-box/units", 9600).json["scale"]["wrong"]["where_small"]["compared"];
  ASSERT_FALSE(compared.empty());
  EXPECT_EQ(compared[0]["quantity"], "|edge x edge| of the half edges whose product parts the two");
  EXPECT_NEAR(compared[0]["least"].get<double>(), 1e-3, 2e-4);
}

// A number that is too large is found too, though the answers at 2^0 are wrong; but nothing is then held against a base
// that is right.
TEST(Invariance, ANumberThatSpoilsTheBaseIsFoundFromTheAnswersThatAreRight) {
  const InvarianceFinding spoilt = found(without_small(1e6), "spans", 9600);
  EXPECT_GT(spoilt.invariance.kinds[ImageKind::scale].changed, 100u);
  const Json& compared = spoilt.json["scale"]["wrong"]["where_small"]["compared"][0];
  EXPECT_EQ(compared["quantity"], "r");
  EXPECT_NEAR(compared["least"].get<double>(), 1e6, 5e5);
}

TEST(Invariance, IsNotBrokenByAnswersThatAreNone) {
  const Kernel silent = right_but([](const Columns& q, std::size_t i, Verdict verdict) {
    return q.column[12][i] < 1e-6 ? Verdict::undecided : verdict;
  });
  const InvarianceFinding undecided = found(silent, "units", 2400);
  EXPECT_EQ(undecided.invariance.kinds[ImageKind::scale].changed, 0u);
  EXPECT_EQ(undecided.invariance.units.wrong.changed, 0u);
  EXPECT_EQ(undecided.asymmetry.verdicts, 0u);
  EXPECT_EQ(undecided.asymmetry.images, undecided.invariance.kinds[ImageKind::scale].images);

  const Kernel nothing = right_but([](const Columns&, std::size_t, Verdict) { return Verdict::undecided; });
  const Json none = json_of(found(nothing, "orders", 600).asymmetry);
  EXPECT_EQ(none["images"], 0);
  for (const char* figure : {"verdicts", "comparisons"}) EXPECT_TRUE(none[figure].is_null()) << figure;
}

// A triangle that the sphere just touches may be called either way by a kernel that rounds: a change there is counted,
// and is not held against it as wrong.
TEST(Invariance, CountsAsWrongOnlyWhatIsClear) {
  const Kernel touching = right_but([](const Columns& columns, std::size_t i, Verdict verdict) {
    Numbers<double> numbers(coordinate_count);
    for (std::size_t k = 0; k < coordinate_count; ++k) numbers[k] = columns.column[k][i];
    const auto q = query_from(numbers);
    return q.r < 1e-6 && distance_order(q) == 0 ? Verdict::separated : verdict;
  });
  const Invariance changed = found(touching, "units", 4800).invariance;
  EXPECT_GT(changed.kinds[ImageKind::scale].changed, 10u);
  EXPECT_EQ(changed.units.wrong.changed, 0u);
  EXPECT_TRUE(changed.units.small.empty());
}

TEST(Invariance, OfOtherKindsIsCountedByKindAndSize) {
  const Kernel far = right_but([](const Columns& q, std::size_t i, Verdict) {
    return std::abs(q.column[9][i]) > 0x1p40 ? Verdict::separated : Verdict::contact;
  });
  const InvarianceFinding moved = found(far, "spans", 12 * 400);
  const ImageChanges& translation = moved.invariance.kinds[ImageKind::translation];
  ASSERT_GT(translation.changed, 0u);
  EXPECT_GE(translation.by_size.begin()->first, 39);
  EXPECT_LT(translation.changed, translation.images);

  const Kernel lopsided = right_but([](const Columns& q, std::size_t i, Verdict) {
    return q.column[9][i] > 0 ? Verdict::separated : Verdict::contact;
  });
  const InvarianceFinding mirrored = found(lopsided, "axes", 48 * 50);
  EXPECT_GT(mirrored.invariance.kinds[ImageKind::mirror].changed, 0u);
  EXPECT_GT(mirrored.invariance.kinds[ImageKind::axes].changed, 0u);
  EXPECT_EQ(mirrored.invariance.kinds[ImageKind::mirror].images, 7u * 50);
  EXPECT_EQ(mirrored.invariance.kinds[ImageKind::axes].images, 40u * 50);
  EXPECT_EQ(mirrored.json.size(), 2u);
}

}  // namespace
}  // namespace axiscert
