// A kernel's touching convention: the right answer to a query that touches, and the cause of a wrong one.
#include <gtest/gtest.h>

#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Touches at A: vertex_a.radius is a tie.
const Query<float> touching{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, 1};
const Query<float> apart{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 0.5};
// A triangle with a repeated vertex, inside the sphere at distance 1 from its centre: the plane's sides are 0 and 0.
const Query<float> zero_area{{1, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, 2};

// Judges `published` evaluated in its own order of operations, or bit for bit.
Judgement judged(const Query<float>& q, TouchingPolicy touching, const Answer& answer, bool is_reference = false) {
  Kernel kernel = find_kernel("published");
  kernel.is_reference = is_reference;
  const ExactTruth truth = exact_truth(q, true);
  return judge(sphere_triangle_predicate(), truth, AskedSphereTriangle(q, Opinion::second).chain(kernel), answer,
               touching);
}
Judgement judged_by_verdict(const Query<float>& q, TouchingPolicy touching, Verdict verdict) {
  return judge(sphere_triangle_predicate(), exact_truth(q, true), std::nullopt, {verdict, std::nullopt}, touching);
}

ComparisonBits exact_bits(const Query<float>& q) { return exact_truth(q, true).sides->strict; }
constexpr auto radius_of_a = one_bit<ComparisonBits>(Comparison::vertex_a_radius);

TEST(Touching, TheConventionSaysWhichVerdictIsWrong) {
  EXPECT_FALSE(judged_by_verdict(touching, TouchingPolicy::contact, Verdict::contact).verdict_flip);
  EXPECT_EQ(judged_by_verdict(touching, TouchingPolicy::contact, Verdict::separated).verdict_flip,
            FlipKind::false_separation);
  EXPECT_FALSE(judged_by_verdict(touching, TouchingPolicy::separated, Verdict::separated).verdict_flip);
  const Judgement wrong = judged_by_verdict(touching, TouchingPolicy::separated, Verdict::contact);
  EXPECT_EQ(wrong.verdict_flip, FlipKind::false_contact);
  EXPECT_EQ(wrong.verdict_links, LinkSet{Link::unattributed});
  for (const Verdict verdict : {Verdict::contact, Verdict::separated}) {
    EXPECT_FALSE(judged_by_verdict(touching, TouchingPolicy::either, verdict).verdict_flip);
  }
}

TEST(Touching, ElsewhereTheConventionIsNothing) {
  for (const TouchingPolicy touching : {TouchingPolicy::contact, TouchingPolicy::separated, TouchingPolicy::either}) {
    EXPECT_EQ(judged_by_verdict(apart, touching, Verdict::contact).verdict_flip, FlipKind::false_contact);
    EXPECT_EQ(judged_by_verdict(zero_area, touching, Verdict::separated).verdict_flip, FlipKind::false_separation);
  }
}

// A kernel that calls touching separated has >= in its radius comparisons: right, and no link is broken.
TEST(Touching, SeparatedMakesTheTieHold) {
  const auto holds = static_cast<ComparisonBits>(exact_bits(touching) | radius_of_a);
  ASSERT_EQ(outcome_of(holds).verdict, Verdict::separated);
  const Judgement right = judged(touching, TouchingPolicy::separated, outcome_of(holds));
  EXPECT_TRUE(right.flips().empty());
  EXPECT_TRUE(right.verdict_links.empty());
  // A kernel that rounds at the tie is wrong, and its specification is not the cause.
  const Judgement rounded = judged(touching, TouchingPolicy::separated, outcome_of(exact_bits(touching)));
  EXPECT_EQ(rounded.verdict_flip, FlipKind::false_contact);
  EXPECT_EQ(rounded.verdict_links, LinkSet{Link::unattributed});
  EXPECT_EQ(rounded.comparison_flips, radius_of_a);
  EXPECT_EQ(rounded.comparison_decisive, radius_of_a);
}

TEST(Touching, EitherLeavesTheTieOpenAndNothingElse) {
  for (const ComparisonBits bits :
       {exact_bits(touching), static_cast<ComparisonBits>(exact_bits(touching) | radius_of_a)}) {
    const Judgement open = judged(touching, TouchingPolicy::either, outcome_of(bits));
    EXPECT_TRUE(open.flips().empty());
    EXPECT_TRUE(open.verdict_links.empty());
  }
  const ComparisonBits wrong_side = exact_bits(touching) ^ one_bit<ComparisonBits>(Comparison::edge_bc_side_a);
  EXPECT_EQ(judged(touching, TouchingPolicy::either, outcome_of(wrong_side)).comparison_flips,
            exact_bits(touching) ^ wrong_side);
}

// 0 >= 0 in the plane axis separates every triangle without area: that is wrong, and the formulae as named do not
// excuse it.
TEST(Touching, AZeroAreaPlaneIsNotExcused) {
  const auto plane = static_cast<ComparisonBits>(exact_bits(zero_area) | comparisons_of(Axis::plane));
  for (const TouchingPolicy touching : {TouchingPolicy::separated, TouchingPolicy::either}) {
    const Judgement wrong = judged(zero_area, touching, outcome_of(plane));
    EXPECT_EQ(wrong.verdict_flip, FlipKind::false_separation);
    EXPECT_EQ(wrong.verdict_links, LinkSet{Link::unattributed});
    EXPECT_EQ(wrong.comparison_decisive, comparisons_of(Axis::plane));
  }
}

// The reference's bits say contact, and so does a kernel that is the reference: its convention contradicts them.
TEST(Touching, AReferenceKeepsItsRelation) {
  const Judgement found = judged(touching, TouchingPolicy::separated, outcome_of(exact_bits(touching)), true);
  EXPECT_EQ(found.verdict_flip, FlipKind::false_contact);
  EXPECT_EQ(found.verdict_links, LinkSet{Link::specification});
  EXPECT_EQ(found.comparison_flips, 0);
  EXPECT_TRUE(judged(touching, TouchingPolicy::contact, outcome_of(exact_bits(touching)), true).flips().empty());
}

// Formulae without comparisons: only their verdict follows the convention.
TEST(Touching, AMethodFollowsTheConventionToo) {
  Kernel kernel = find_kernel("minkowski");
  kernel.is_reference = false;
  const ExactTruth truth = exact_truth(touching, true);
  const auto chain = AskedSphereTriangle(touching, Opinion::second).chain(kernel);
  EXPECT_EQ(
      judge(sphere_triangle_predicate(), truth, chain, {Verdict::separated, std::nullopt}, TouchingPolicy::separated)
          .verdict_links,
      LinkSet{});
  EXPECT_EQ(
      judge(sphere_triangle_predicate(), truth, chain, {Verdict::contact, std::nullopt}, TouchingPolicy::separated)
          .verdict_links,
      LinkSet{Link::unattributed});
  for (const Verdict verdict : {Verdict::contact, Verdict::separated}) {
    EXPECT_EQ(
        judge(sphere_triangle_predicate(), truth, chain, {verdict, std::nullopt}, TouchingPolicy::either).verdict_links,
        LinkSet{});
  }
}

TEST(Judge, NoAnswerIsNoFlip) {
  const Judgement none = judged(apart, TouchingPolicy::contact, {Verdict::unanswered, std::nullopt});
  EXPECT_TRUE(none.flips().empty());
  EXPECT_TRUE(none.verdict_links.empty());
}

}  // namespace
}  // namespace axiscert
