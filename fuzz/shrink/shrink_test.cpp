// Shrinking: each step is smaller, it ends, and the result is wrong in the same way and no less severely.
#include "fuzz/shrink/shrink.h"

#include <gtest/gtest.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/queries/source.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/shrink/pair.h"
#include "fuzz/shrink/shrink_moves.h"
#include "fuzz/sphere_triangle/images.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t seed = 5;

// |d - r| / s at 4000 bits, from the rationals: independent of the decisions in depth.cpp.
class WideDepth {
 public:
  explicit WideDepth(const ExactDepth& x) {
    mpfr_t s;
    mpfr_inits2(4000, value_, s, nullptr);
    mpfr_set_q(value_, x.dd.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(value_, value_, MPFR_RNDN);
    mpfr_sub_q(value_, value_, x.r.get_mpq_t(), MPFR_RNDN);
    mpfr_abs(value_, value_, MPFR_RNDN);
    mpfr_set_q(s, x.ss.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(s, s, MPFR_RNDN);
    mpfr_div(value_, value_, s, MPFR_RNDN);
    mpfr_clear(s);
  }
  ~WideDepth() { mpfr_clear(value_); }
  WideDepth(const WideDepth&) = delete;
  WideDepth& operator=(const WideDepth&) = delete;
  // 0 if they agree to 3900 bits.
  int order(const WideDepth& other) const {
    return mpfr_eq(value_, other.value_, 3900) != 0 ? 0 : mpfr_cmp(value_, other.value_);
  }

 private:
  mpfr_t value_;
};

template <class Real>
ExactDepth depth_of(const Query<Real>& q) {
  return exact_depth(q, squared_distance(q));
}

TEST(DepthOrder, AgreesWithMpfr) {
  const Family& family = find_family("tangent");
  std::vector<ExactDepth> depths;
  for (std::uint64_t n = 0; n < 60; ++n) {
    const Query<float> q = family.make<float>(seed, n);
    depths.push_back(depth_of(q));
    auto v = coordinates(q);  // eight times as large: equally deep
    for (float& x : v) x *= 8;
    depths.push_back(depth_of(from_coordinates(v)));
  }
  int equal = 0;
  std::deque<WideDepth> wides;
  for (const ExactDepth& x : depths) wides.emplace_back(x);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const int order = compare(depths[i], depths[k]), wide = wides[i].order(wides[k]);
      ASSERT_EQ((order > 0) - (order < 0), (wide > 0) - (wide < 0));
      equal += order == 0;
    }
  }
  EXPECT_GE(equal, 240);
}

TEST(QuerySize, CountsWhatAReaderSees) {
  const Query<float> q = {{3, 0, -0.0f}, {-3, 0.5f, 0}, {0, 0, 0}, {0, 0, 0x1p-149f}, 1.25f};
  EXPECT_EQ(size_of(q), (QuerySize{5, 2 + 2 + 1 + 1 + 3, 1 + 1 + 1 + 149 + 0, 4, 2, 0 + 3 + 4 + 11 + 12}));
  EXPECT_LT(size_of(Query<float>{}), size_of(q));
}

// Whether the query shows the symptom, by everything that `check` asks, without the code under test.
template <class Real>
bool shows(const Query<Real>& q, const Symptom& symptom, const Kernel& kernel) {
  Examiner examiner(kernel, scalar_target);
  const auto flips = examiner.examine(q).judgement.flips();
  return std::any_of(flips.begin(), flips.end(), [&](const Flip& flip) {
    return flip.level == symptom.level && flip.index == symptom.index && flip.kind == symptom.kind &&
           flip.links == symptom.links && flip.decisive >= symptom.decisive;
  });
}

template <class Real>
void expect_smaller_and_as_bad(const Query<Real>& q, const Symptom& symptom, const Kernel& kernel) {
  SCOPED_TRACE(text(symptom) + " of " + kernel.id);
  const auto found = shrink<Real>(q, symptom, kernel, scalar_target, 20000);
  const Query<Real> smaller = found.query;
  ASSERT_EQ(found.sizes.front(), size_of(q));
  ASSERT_EQ(found.sizes.back(), size_of(found.query));
  for (std::size_t i = 1; i < found.sizes.size(); ++i) ASSERT_LT(found.sizes[i], found.sizes[i - 1]);
  EXPECT_GT(found.sizes.size(), 1u);
  EXPECT_TRUE(is_no_less(found.after, found.before));
  if (symptom.kind) {
    EXPECT_TRUE(shows(smaller, symptom, kernel));
  }
  const InputClassSet before = input_classes(q, squared_distance(q));
  const InputClassSet after = input_classes(smaller, squared_distance(smaller));
  EXPECT_EQ(class_of(after), class_of(before));
  EXPECT_TRUE(before.contains_all(after));
  if (symptom.level == Level::verdict) {
    EXPECT_LE(depth(smaller, squared_distance(smaller)), depth_factor * depth(q, squared_distance(q)) * 1.001);
    EXPECT_GE(WideDepth(depth_of(smaller)).order(WideDepth(depth_of(q))), 0);
  }
}

// The first queries of a family on which a kernel is wrong, each with one symptom of each level.
template <class Real>
void shrink_the_first(const char* kernel_id, const char* family, int wanted, const std::uint64_t trials) {
  const Kernel& kernel = find_kernel(kernel_id);
  SymptomFinder<Real> finder(kernel, scalar_target);
  for (std::uint64_t n = 0; n < trials && wanted > 0; ++n) {
    const Query<Real> q = find_family(family).make<Real>(seed, n);
    if (!is_valid(q)) continue;
    const auto flips = finder.flips(q);
    if (flips.empty()) continue;
    SCOPED_TRACE(testing::Message() << family << ", seed " << seed << ", position " << n);
    std::optional<Level> last;
    for (const Symptom& symptom : flips) {
      if (last != symptom.level) expect_smaller_and_as_bad(q, symptom, kernel);
      last = symptom.level;
    }
    --wanted;
  }
  EXPECT_EQ(wanted, 0) << kernel_id << " on " << family << ", seed " << seed;
}

TEST(Shrink, KeepsWhatIsWrongAndHowBadly) {
  shrink_the_first<float>("published", "tangent", 1, 2000);
  shrink_the_first<float>("published", "scale", 1, 2000);
}
// Queries of a family: one in a slow build, where each takes a minute.
constexpr int in_this_build(int queries) { return std::max(queries / TRIAL_DIVISOR, 1); }

TEST(ShrinkLong, EveryKindOfKernelAndBothPrecisions) {
  for (const char* family : {"tangent", "sliver", "scale", "repeated", "subnormal", "bits"}) {
    shrink_the_first<float>("published", family, in_this_build(6), 20000);
    shrink_the_first<double>("published", family, in_this_build(2), 20000);
  }
  shrink_the_first<float>("nonstrict", "tangent", in_this_build(4), 20000);
  shrink_the_first<float>("ladder-0", "tangent", in_this_build(4), 20000);
  shrink_the_first<float>("closest-point", "tangent", in_this_build(4), 20000);
  shrink_the_first<float>("eigen", "tangent", in_this_build(4), 20000);
}

TEST(Shrink, KeepsTheErrorOfAComparison) {
  const Query<float> q = find_family("sliver").make<float>(seed, 1);
  for (const char* id : {"published", "ladder-0"}) {
    const Symptom error{.predicate = &sphere_triangle_predicate(),
                        .level = Level::comparison,
                        .index = static_cast<std::uint8_t>(Comparison::edge_bc_radius)};
    expect_smaller_and_as_bad(q, error, find_kernel(id));
  }
}

TEST(Shrink, TheLimitEndsItAndSaysSo) {
  const Kernel& kernel = find_kernel("published");
  SymptomFinder<float> finder(kernel, scalar_target);
  std::uint64_t n = 0;
  const auto at = [&]() -> Query<float> { return find_family("tangent").make<float>(seed, n); };
  while (finder.flips(at()).empty()) ++n;
  const auto found = shrink<float>(at(), finder.flips(at()).front(), kernel, scalar_target, 3);
  EXPECT_EQ(found.evaluations, 3u);
  EXPECT_FALSE(found.complete);
}

// An exact kernel with a fault of rounding, and a deep one on triangles with equal vertices.
Kernel two_faults() {
  return black_box(
      "two faults",
      [](const Query<double>& q, std::size_t, Verdict& verdict, std::vector<Finding>&) {
        if (!is_valid(q)) return;
        const InputClassSet meets = input_classes(q, squared_distance(q));
        if (meets.contains(InputClass::repeated) || class_of(meets) == InputClass::near_tie)
          verdict = Verdict::separated;
      },
      "certified");
}

// A missed contact of an ulp on an ordinary triangle: as small as it goes, it is another fault.
TEST(Shrink, KeepsTheClassOfTheInputAndTheDepth) {
  const Kernel kernel = two_faults();
  const Query<double> q = {{1, 0.25, 1}, {-0.5, 1, 1}, {-1, -1.25, 1}, {0.125, 0.0625, 0}, 1 + 0x1p-50};
  const Symptom missed{.predicate = &sphere_triangle_predicate(),
                       .kind = FlipKind::false_separation,
                       .decisive = true,
                       .links = {Link::unattributed}};
  const auto kept = shrink<double>(q, missed, kernel, scalar_target, 3000);
  const Query<double> smaller = kept.query;
  EXPECT_EQ(input_classes(smaller, squared_distance(smaller)), InputClassSet{InputClass::near_tie});
  EXPECT_EQ(*kept.kept.classes(), std::vector<std::string_view>{"near_tie"});
  EXPECT_LT(kept.sizes.back(), kept.sizes.front());
  EXPECT_LT(depth(smaller, squared_distance(smaller)), 4e-15);
  const auto free = shrink<double>(q, missed, kernel, scalar_target, 3000, KeepingRule::symptom);
  const Query<double> smallest = free.query;
  EXPECT_FALSE(free.kept.classes());
  EXPECT_GT(depth(smallest, squared_distance(smallest)), 0.01) << "what the class is kept against";
  EXPECT_TRUE(shape_classes(smallest).contains(InputClass::repeated));
}

TEST(ImageMaps, AreFoundFromThePairAlone) {
  for (const char* family : {"orders", "axes", "inverted", "scaled", "translated", "units", "spans"}) {
    const ImageGroup& group = *image_group(family);
    const auto query = [&](std::uint64_t n) -> Query<float> { return find_family(family).make<float>(seed, n); };
    for (std::uint64_t base = 0; base < 8 * group.size; base += group.size) {
      for (std::uint64_t n = base; n < base + group.size; ++n) {
        const auto map = map_between(query(base), query(n)), back = map_between(query(n), query(base));
        ASSERT_TRUE(map && back) << family << ", seed " << seed << ", position " << n;
        EXPECT_EQ(coordinates(*image_by(*map, query(base))), coordinates(query(n)));
        EXPECT_EQ(coordinates(*image_by(*back, query(n))), coordinates(query(base)));
      }
    }
    EXPECT_FALSE(map_between(query(0), query(group.size))) << "another base";
  }
}

TEST(ImageMaps, AnImageThatThePrecisionCannotHoldIsNone) {
  const Query<float> q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, 0x1p-24f};
  TriangleMap map{symmetries()[0], 0, {Rational(1), Rational(1), Rational(1)}};
  EXPECT_TRUE(image_by(map, q));
  map.by[1] = Rational(1, 3);
  EXPECT_FALSE(image_by(map, q));
  map = {symmetries()[0], -140, {}};
  EXPECT_FALSE(image_by(map, q)) << "r underflows";
}

// A kernel with an absolute epsilon is right about a query and wrong about its image: neither alone shows why.
TEST(ShrinkPairs, TheAnswersToTheSmallerQueryAndItsImageStillDiffer) {
  const auto epsilon = [](const Query<double>& q, std::size_t, Verdict& verdict, std::vector<Finding>&) {
    if (std::fabs(q.a.x - q.p.x) < 1e-4 && q.r > 0) verdict = Verdict::contact;
  };
  const Kernel kernel = black_box("epsilon", epsilon, "certified");
  const ImageGroup& group = *image_group("scaled");
  int pairs = 0, right_alone = 0;
  for (std::uint64_t n = 0; n < 400 && pairs < 4; ++n) {
    const std::string address = text(Address{seed, "scaled", find_family("scaled").version, Precision::binary32, 0, n});
    const auto pair = asymmetric_pair<float>(address, kernel, scalar_target);
    if (!pair) continue;
    ++pairs;
    EXPECT_TRUE(asymmetric_pair(pair->query, address, kernel, scalar_target));
    EXPECT_FALSE(asymmetric_pair(pair->image, address, kernel, scalar_target)) << "its numbers are not the address's";
    right_alone += SymptomFinder<float>(kernel, scalar_target).flips(pair->query).empty();
    EXPECT_NE(pair->symptom.of_query, pair->symptom.of_image);
    const auto found = shrink_pair(*pair, kernel, scalar_target, 3000);
    EXPECT_LT(found.query.sizes.back(), found.query.sizes.front()) << address;
    Examiner examiner(kernel, scalar_target);
    EXPECT_EQ(examiner.examine(found.query.query).answer.verdict, pair->symptom.of_query);
    EXPECT_EQ(examiner.examine(found.image).answer.verdict, pair->symptom.of_image);
    EXPECT_EQ(map_between<float>(found.query.query, found.image)->exponent,
              map_between<float>(pair->query, pair->image)->exponent);
    n += group.size;
  }
  EXPECT_EQ(pairs, 4) << "seed " << seed;
  EXPECT_GT(right_alone, 0);
  EXPECT_FALSE(asymmetric_pair<float>("1:general:2:binary32:0:1", kernel, scalar_target));
  EXPECT_FALSE(asymmetric_pair<float>("at home", kernel, scalar_target));
  EXPECT_FALSE(asymmetric_pair<float>("1:scaled:1:half:0:1", kernel, scalar_target));
}

TEST(Shrink, AQueryWithoutTheSymptomIsAnError) {
  const Query<float> q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, 2};
  const Symptom symptom{.predicate = &sphere_triangle_predicate(),
                        .kind = FlipKind::false_separation,
                        .decisive = true,
                        .links = {Link::rounding}};
  EXPECT_THROW(shrink<float>(q, symptom, find_kernel("published"), scalar_target, 10), Error);
}

}  // namespace
}  // namespace axiscert
