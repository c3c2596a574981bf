// Families of images: every image is exact, so that exact arithmetic gives the same answers as for the base; and
// differing answers of a kernel are counted.
#include "fuzz/queries/image_groups.h"

#include <cmath>
#include <set>

#include "exact/numbers/rational.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/queries/family_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Those of the first predicate; the room of any other has tests of its own groups.
std::vector<const ImageGroup*> groups_of_first_predicate() {
  std::vector<const ImageGroup*> groups = image_groups();
  std::erase_if(groups, [](const ImageGroup* group) { return &group->predicate() != &sphere_triangle_predicate(); });
  return groups;
}

template <class Real>
class Images : public testing::Test {};
TYPED_TEST_SUITE(Images, Reals);

// The squared distances between the four points, and r, in rationals: these determine a query up to a symmetry.
template <class Real>
std::array<Rational, 7> shape(const Query<Real>& q, const std::array<std::uint8_t, 3>& order) {
  std::array<Vec3<Real>, 4> points;
  points[order[0]] = q.a;
  points[order[1]] = q.b;
  points[order[2]] = q.c;
  points[3] = q.p;
  std::array<Rational, 7> out;
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) {
      Rational sum;
      for (const auto& [x, y] :
           {std::pair{points[i].x, points[k].x}, {points[i].y, points[k].y}, {points[i].z, points[k].z}}) {
        const Rational d = exact(x) - exact(y);
        sum += d * d;
      }
      out[n++] = sum;
    }
  }
  out[6] = exact(q.r) * exact(q.r);
  return out;
}

// All seven are multiplied by the same power of two.
TYPED_TEST(Images, AreExactly) {
  for (const ImageGroup* const each : groups_of_first_predicate()) {
    const ImageGroup& group = *each;
    std::array<Rational, 7> base;
    for_each_query<TypeParam>(group.family, 40 * group.size, [&](const Query<TypeParam>& q, std::uint64_t position) {
      const std::size_t image = position % group.size;
      const auto found = shape(q, group.order(image));
      if (image == 0) base = found;
      Rational factor = 1;
      for (std::size_t k = 0; k < 7; ++k) {
        if (base[k] != 0) factor = found[k] / base[k];
      }
      for (std::size_t k = 0; k < 7; ++k) EXPECT_EQ(found[k], Rational(base[k] * factor)) << k;
      EXPECT_EQ(factor == 1, image == 0 || group.kind(image) != ImageKind::scale);
      if (image != 0 && group.kind(image) == ImageKind::scale) {
        const int exponent = group.exponent(precision_of<TypeParam>, position / group.size, image);
        EXPECT_EQ(factor, exact(std::ldexp(1.0, 2 * exponent)));
        EXPECT_TRUE(!group.range || group.range(precision_of<TypeParam>).contains(exponent));
      }
    });
  }
}

// MPFR gives the same answers for every image, by the base's names of the comparisons.
TYPED_TEST(Images, HaveTheExactAnswersOfTheBase) {
  for (const ImageGroup* const each : groups_of_first_predicate()) {
    const ImageGroup& group = *each;
    SecondOpinion base;
    for_each_query<TypeParam>(group.family, 12 * group.size, [&](const Query<TypeParam>& q, std::uint64_t position) {
      const std::size_t image = position % group.size;
      const SecondOpinion found = second_opinion(q);
      if (image == 0) base = found;
      EXPECT_EQ(found.distance_order, base.distance_order);
      const ComparisonsOfBase of_base(sphere_triangle_predicate(), group.order(image));
      EXPECT_EQ(of_base(found.strict), base.strict);
      EXPECT_EQ(of_base(found.ties), base.ties);
    });
  }
}

TEST(ImageGroups, HaveTheSizesTheyClaimAndAreAllDifferent) {
  std::vector<std::size_t> sizes;
  for (const ImageGroup* const each : groups_of_first_predicate()) {
    const ImageGroup& group = *each;
    sizes.push_back(group.size);
    EXPECT_EQ(image_group(group.family), &group);
    std::set<std::array<float, coordinate_count>> images;
    const Family& family = find_family(group.family);
    for (std::size_t i = 0; i < group.size; ++i) images.insert(coordinates(query_from(family.make<float>(1, i))));
    EXPECT_EQ(images.size(), group.size) << group.family;
  }
  EXPECT_EQ(sizes, (std::vector<std::size_t>{6, 48, 2, 8, 4, 8, 12}));
  EXPECT_EQ(image_group("tangent"), nullptr);
}

TEST(ImageGroups, NameTheComparisonsOfTheBase) {
  const ComparisonsOfBase in_order(sphere_triangle_predicate(), {0, 1, 2}),
      turned(sphere_triangle_predicate(), {2, 0, 1});
  EXPECT_EQ(in_order(0xffff), 0xffffu);
  const auto bit = [](Comparison comparison) { return one_bit<ComparisonBits>(static_cast<std::size_t>(comparison)); };
  // The image's A is the base's C, its B the base's A, its C the base's B.
  EXPECT_EQ(turned(bit(Comparison::vertex_b_side_c)), bit(Comparison::vertex_a_side_b));
  EXPECT_EQ(turned(bit(Comparison::edge_ab_side_c)), bit(Comparison::edge_ca_side_b));
  EXPECT_EQ(turned(bit(Comparison::plane_radius)), bit(Comparison::plane_radius));
}

// `published`, but wrong on queries for which `is_wrong` holds.
template <class IsWrong>
Kernel published_but(const IsWrong& is_wrong) {
  Kernel kernel = find_kernel("published");
  kernel.binary32 = [is_wrong](std::string_view target) {
    Implementation<float> right = find_kernel("published").on<float>(target);
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

Asymmetry counted(const Kernel& kernel, const char* family, std::uint64_t queries) {
  const SourcePtr source = family_source(find_family(family));
  return *asymmetry_of({*source, 1, Precision::binary32}, queries, kernel, nullptr, {resolve_target("auto")});
}

TEST(Asymmetries, OfThePublishedTestAreThoseOfItsRoundings) {
  const Kernel& published = find_kernel("published");
  const std::uint64_t queries = 9600;
  // Sums of products in another order round differently; a sign, a power of two within the range and an exact
  // translation change no rounding.
  EXPECT_GT(counted(published, "orders", queries).verdicts, 0u);
  EXPECT_GT(counted(published, "axes", queries).verdicts, 0u);
  for (const char* family : {"inverted", "translated"}) {
    const Asymmetry found = counted(published, family, queries);
    EXPECT_EQ(found.verdicts + found.comparisons, 0u) << family;
    EXPECT_FALSE(found.first_verdict || found.first_comparison);
  }
  const Asymmetry scaled = counted(published, "scaled", queries);  // 2^20 and 2^31 are beyond the range
  EXPECT_EQ(scaled.images, queries / 8 * 7);
  EXPECT_GT(scaled.verdicts, 0u);
  ASSERT_TRUE(scaled.first_verdict);
  EXPECT_EQ(scaled.first_verdict->base % 8, 0u);
  EXPECT_LT(scaled.first_verdict->image - scaled.first_verdict->base, 8u);
}

TEST(Asymmetries, AreFoundWhereAFaultIsPlanted) {
  const auto negative = published_but([](const QueryColumns<float>& q, std::size_t i) {
    float sum = 0;
    for (std::size_t k = 0; k < 12; ++k) sum += q.column[k][i];
    return sum < 0;
  });
  const auto far =
      published_but([](const QueryColumns<float>& q, std::size_t i) { return std::fabs(q.column[9][i]) > 1; });
  for (const char* family : {"inverted", "axes"}) EXPECT_GT(counted(negative, family, 960).verdicts, 0u) << family;
  EXPECT_GT(counted(far, "translated", 960).verdicts, 0u);
}

TEST(Asymmetries, AreThoseOfWholeGroups) {
  const Kernel& published = find_kernel("published");
  EXPECT_EQ(counted(published, "axes", 47).images, 0u);
  EXPECT_EQ(counted(published, "axes", 48 * 3 + 5).images, 47u * 3);
  const SourcePtr tangent = family_source(find_family("tangent"));
  EXPECT_FALSE(asymmetry_of({*tangent, 1, Precision::binary32}, 100, published, nullptr, {}));
}

}  // namespace
}  // namespace axiscert
