// Shrinking a query of another predicate than the first: by its description and its oracles alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/judge/examine.h"
#include "fuzz/queries/family.h"
#include "fuzz/shrink/shrink.h"
#include "fuzz/shrink/shrink_moves.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t motion_seed = 3;

const Predicate& motions() { return find_predicate("moving-sphere"); }

// The first query of the family on which the kernel is wrong.
template <class Real>
Numbers<Real> first_wrong(const Kernel& kernel, const char* family) {
  SymptomFinder<Real> finder(kernel, scalar_target);
  std::uint64_t n = 0;
  const auto at = [&] { return find_family(family).make<Real>(motion_seed, n); };
  while (finder.flips(at()).empty() && n < 5000) ++n;
  SCOPED_TRACE(testing::Message() << family << ", seed " << motion_seed << ", position " << n);
  EXPECT_LT(n, 5000u);
  return at();
}

template <class Real>
void expect_the_same_fault(const char* kernel_id, const char* family) {
  SCOPED_TRACE(std::string(kernel_id) + " on " + family);
  const Kernel& kernel = find_kernel(kernel_id);
  const Numbers<Real> q = first_wrong<Real>(kernel, family);
  SymptomFinder<Real> finder(kernel, scalar_target);
  const Symptom symptom = finder.flips(q).front();
  const auto found = shrink<Real>(q, symptom, kernel, scalar_target, 600);
  ASSERT_GT(found.sizes.size(), 1u);
  for (std::size_t i = 1; i < found.sizes.size(); ++i) ASSERT_LT(found.sizes[i], found.sizes[i - 1]);
  Examiner examiner(kernel, scalar_target);
  const Examination before = examiner.examine(q), after = examiner.examine(found.query);
  EXPECT_EQ(after.judgement.verdict_flip, before.judgement.verdict_flip);
  EXPECT_EQ(after.judgement.verdict_links, before.judgement.verdict_links);
  EXPECT_GE(*after.depth, *before.depth);
  EXPECT_LE(*after.depth, depth_factor * *before.depth);
  EXPECT_EQ(classes_of(motions(), found.query).front(), classes_of(motions(), q).front());
}

TEST(ShrinkMotions, KeepWhatIsWrongHowBadlyAndTheClass) {
  expect_the_same_fault<float>("moving-sphere/rounded", "moving-sphere/approach");
  expect_the_same_fault<float>("moving-sphere/twenty", "moving-sphere/graze");
  expect_the_same_fault<double>("moving-sphere/twenty", "moving-sphere/lattice");
}

TEST(ShrinkMotions, TheMovesFollowFromTheDescription) {
  const QueryShape shape = shape_of(motions().entries.front());
  EXPECT_EQ(shape.points, (std::vector<std::size_t>{0, 3, 6, 9}));
  EXPECT_EQ(shape.directions, std::vector<std::size_t>{12});
  EXPECT_TRUE(shape.is_length[15]);
  const Numbers<float> q = {1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 1, 2, -4, 0, 2, 0.5f};
  const auto by = [&](MoveKind kind, int i, int j) { return *moved(shape, q, {kind, i, j}); };
  const auto is = [](const Numbers<float>& x, std::initializer_list<float> y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end());
  };
  EXPECT_TRUE(is(by(MoveKind::translate, 3, 3), {0, 1, 1, 3, 4, 4, 6, 7, 7, 0, 0, 0, -4, 0, 2, 0.5f}))
      << "a translation leaves directions and lengths";
  EXPECT_TRUE(is(by(MoveKind::flatten, 2, 0), {1, 2, 0, 4, 5, 0, 7, 8, 0, 1, 1, 0, -4, 0, 0, 0.5f}));
  EXPECT_TRUE(is(by(MoveKind::zero_direction, 0, 0), {1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 1, 2, 0, 0, 0, 0.5f}));
  EXPECT_TRUE(is(by(MoveKind::along, 0, -1), {1, 2, 3, 4, 5, 6, 7, 8, 9, -1, 1, 3, -4, 0, 2, 0.5f}));
  EXPECT_TRUE(is(by(MoveKind::reverse, 0, 0), {1, 2, 3, 4, 5, 6, 7, 8, 9, -3, 1, 4, 4, 0, -2, 0.5f}));
  EXPECT_TRUE(is(by(MoveKind::between, 0, 1), {1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 1, 2, 3, 3, 3, 0.5f}));
  EXPECT_FALSE(moved(shape, q, {MoveKind::negate, 15, 0})) << "no length is negative";
}

// The list, by which combined steps are drawn, decides what a shrunk query is, to the byte.
TEST(ShrinkMotions, WithoutDirectionsTheMovesAreThoseThatTheyWere) {
  const QueryShape shape = shape_of(sphere_triangle_predicate().entries.front());
  EXPECT_EQ(moves<float>(shape).size(), 1961u);
  EXPECT_EQ(moves<double>(shape).size(), 2744u);
  for (const Move& move : moves<float>(shape)) EXPECT_LT(move.kind, MoveKind::zero_direction);
}

TEST(ShrinkMotions, TheClassOfAMotionIsExact) {
  const auto classes = [](const Numbers<float>& q) { return classes_of(motions(), q); };
  using Names = std::vector<std::string_view>;
  // Down on the face.
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3, 0, 0, -4, 1}), Names{"ordinary"});
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3, 1, 0, 0, 1}), Names{"parallel"});
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 3, 1, 0, -0x1p-20f, 1}), Names{"ordinary"});
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, 1, 1, 0, 0, 1}), (Names{"tie", "near_tie", "parallel"}));
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 8, 0, 0, 1, 1, 3, 0, 0, 0, 0}), (Names{"collinear", "still", "point"}));
  EXPECT_EQ(classes({0, 0, 0, 4, 0, 0, 4, 0, 0, 1, 1, 3, 0, 0, 1, 1}), (Names{"repeated", "collinear"}));
  EXPECT_EQ(classes({500, 0, 0, 504, 0, 0, 500, 4, 0, 501, 1, 3, 0, 0, 1, 1}), Names{"far"});
}

}  // namespace

// Shrinking two boxes: the same fault, no less deep, of axes that stay rotations.

namespace {

constexpr std::uint64_t boxes_to_shrink_seed = 3;

template <class Real>
void expect_the_same_fault_of_boxes(const char* kernel_id, const char* family) {
  SCOPED_TRACE(std::string(kernel_id) + " on " + family);
  const Kernel& kernel = find_kernel(kernel_id);
  SymptomFinder<Real> finder(kernel, scalar_target);
  std::uint64_t n = 0;
  const auto at = [&] { return find_family(family).make<Real>(boxes_to_shrink_seed, n); };
  const auto is_wrong = [&] {
    const std::vector<Symptom> flips = finder.flips(at());
    return !flips.empty() && flips.front().level == Level::verdict;
  };
  while (n < 2000 && !is_wrong()) ++n;
  ASSERT_LT(n, 2000u);
  const Numbers<Real> q = at();
  const Symptom symptom = finder.flips(q).front();
  const auto found = shrink<Real>(q, symptom, kernel, scalar_target, 400);
  ASSERT_GT(found.sizes.size(), 1u);
  Examiner examiner(kernel, scalar_target);
  const Examination before = examiner.examine(q), after = examiner.examine(found.query);
  EXPECT_EQ(after.judgement.verdict_flip, before.judgement.verdict_flip);
  EXPECT_EQ(after.judgement.verdict_links, before.judgement.verdict_links);
  EXPECT_GE(*after.depth, *before.depth);
  EXPECT_LE(*after.depth, depth_factor * *before.depth);
  const QueryShape shape = shape_of(kernel.predicate->entries[kernel.entry]);
  for (const std::size_t first : shape.frames) EXPECT_TRUE(is_nearly_rotation(found.query, first));
}

TEST(ShrinkBoxes, KeepWhatIsWrongAndThatAxesAreRotations) {
  expect_the_same_fault_of_boxes<float>("box-box/textbook", "box-box/resting");
  expect_the_same_fault_of_boxes<double>("box-box/gottschalk", "box-box/crossed");
  expect_the_same_fault_of_boxes<float>("box-box/textbook-turned", "box-box/resting_turned");
  expect_the_same_fault_of_boxes<float>("box-triangle/textbook-minmax", "box-triangle/voxel");
}

TEST(ShrinkBoxes, TheMovesOfAFrame) {
  const PredicateEntry& entry = find_predicate("box-box").entries[0];
  const QueryShape shape = shape_of(entry);
  Numbers<double> q(30);
  for (std::size_t k = 0; k < 30; ++k) q[k] = 0;
  for (const std::size_t k : {3, 4, 5, 18, 19, 20}) q[k] = 1;
  q[0] = 5;  // A at (5, 0, 0), a quarter turn about z: axes y, -x, z
  q[7] = 1, q[9] = -1, q[14] = 1;
  q[15] = 5, q[16] = 2;  // B at (5, 2, 0), upright
  q[21] = q[25] = q[29] = 1;
  const Numbers<double> turned = *moved(shape, q, {MoveKind::into_frame, 0, 0});
  EXPECT_EQ(turned[0], 0);
  EXPECT_EQ(turned[6], 1) << "A upright";
  EXPECT_EQ(turned[15], 2) << "two along A's first axis";
  EXPECT_EQ(turned[16], 0);
  EXPECT_EQ(turned[22], -1) << "B's first axis is minus A's second";
  EXPECT_EQ((*moved(shape, q, {MoveKind::upright, 0, 0}))[6], 1);
  EXPECT_EQ((*moved(shape, q, {MoveKind::copy_frame, 1, 0}))[22], 1);
  // Without frames the list is that of before.
  EXPECT_EQ(moves<float>(shape_of(sphere_triangle_predicate().entries.front())).size(), 1961u);
}

TEST(ShrinkBoxes, AxesThatAreNoRotationAreAClass) {
  const Predicate& boxes = find_predicate("box-box");
  const Numbers<float> resting = find_family("box-box/resting").make<float>(1, 0);
  const auto has_sheared = [&](const Numbers<float>& q) {
    const auto names = classes_of(boxes, q, 0);
    return std::find(names.begin(), names.end(), "sheared") != names.end();
  };
  EXPECT_FALSE(has_sheared(resting));
  Numbers<float> sheared = resting;
  sheared[6] *= 1.0001f;
  EXPECT_TRUE(has_sheared(sheared));
}

}  // namespace

}  // namespace axiscert
