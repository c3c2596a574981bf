// The judge on queries worked out by hand: links, masked and decisive flips, depth.
#include "exact/judge/judge.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/judge/examine.h"
#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

Examination judged(const Query<float>& q, const char* kernel = "published") {
  return Examiner(find_kernel(kernel), scalar_target).examine(q);
}

// Describes every flip as "name kind decisive|masked link...", in order.
std::vector<std::string> told(const Judgement& judgement) {
  std::vector<std::string> lines;
  for (const Flip& flip : judgement.flips()) {
    std::string line(name(sphere_triangle_predicate(), flip));
    line += " " + std::string(flip_kind_names[flip.kind]);
    line += flip.decisive ? " decisive" : " masked";
    for (const Link link : flip.links) line += " " + std::string(link_names[link]);
    lines.push_back(line);
  }
  return lines;
}
using Lines = std::vector<std::string>;

// 1: a segment from (2,0,0) to (3,0,0) given as A = B, and a unit sphere: separated by 1, but no strict axis separates.
TEST(HandWorked, RepeatedVertexIsASpecificationFault) {
  const auto found = judged({{2, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, 1});
  EXPECT_EQ(told(found.judgement), Lines{"verdict false_contact decisive specification"});
  EXPECT_EQ(*found.depth, 1.0 / 3.0);  // (2 - 1) / 3, rounded once
}

// 2: three points on a line, the nearest inside AB: distance 2, depth 1 / sqrt(8).
TEST(HandWorked, CollinearIsASpecificationFault) {
  const auto found = judged({{2, -1, 0}, {2, 1, 0}, {2, 2, 0}, {0, 0, 0}, 1});
  EXPECT_EQ(told(found.judgement), Lines{"verdict false_contact decisive specification"});
  EXPECT_EQ(*found.depth, std::sqrt(0.125));
}

// 3: the same two with non-strict sides.
TEST(HandWorked, NonstrictSidesMendBoth) {
  EXPECT_TRUE(judged({{2, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, 1}, "nonstrict").judgement.flips().empty());
  EXPECT_TRUE(judged({{2, -1, 0}, {2, 1, 0}, {2, 2, 0}, {0, 0, 0}, 1}, "nonstrict").judgement.flips().empty());
}

// 4: only the edge AB separates, and at scale 2^30 both of its radius sides overflow to infinity; so do the radius
// sides of the other edges, whose side comparisons fail anyway.
TEST(HandWorked, OverflowIsARangeFault) {
  const float s = 0x1p30f;
  const auto found = judged({{-s, 2 * s, 0}, {s, 2 * s, 0}, {0, 3 * s, 0}, {0, 0, 0}, s});
  EXPECT_EQ(told(found.judgement),
            (Lines{"verdict false_contact decisive range", "edge_ab missed_separation decisive range",
                   "edge_ab.radius missed_separation decisive range", "edge_bc.radius missed_separation masked range",
                   "edge_ca.radius missed_separation masked range"}));
  EXPECT_EQ(*found.depth, 1.0 / 3.0);  // (2 - 1) / |C|
}

// 5: the vertex A at distance sqrt(3), r the float below it; r r rounds up to 3, and 3 > 3 fails.
const float below_root3 = 0x1.bb67aep0f;
TEST(HandWorked, ARoundedSquareIsARoundingFault) {
  const auto found = judged({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 0}, below_root3});
  EXPECT_EQ(found.truth.verdict, Verdict::separated);
  EXPECT_EQ(told(found.judgement),
            (Lines{"verdict false_contact decisive rounding", "vertex_a missed_separation decisive rounding",
                   "vertex_a.radius missed_separation decisive rounding"}));
  EXPECT_EQ(*found.depth, 0x1.b411ff795f13ep-27);  // (sqrt(3) - r) / sqrt(6), from 50 decimal digits
}

// 6: one float further the sphere reaches A.
TEST(HandWorked, TheNextRadiusIsAContactAndNothingFlips) {
  const auto found = judged({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 0, 0}, std::nextafter(below_root3, 2.f)});
  EXPECT_EQ(found.truth.verdict, Verdict::contact);
  EXPECT_FALSE(found.truth.touching);
  EXPECT_TRUE(found.judgement.flips().empty());
}

// 7: the same flip at A with B inside the sphere: the axis fails anyway, and the flip has no effect.
TEST(HandWorked, AFlipThatChangesNothingIsMasked) {
  const auto found = judged({{1, 1, 1}, {0, 0, 1}, {1, 2, 1}, {0, 0, 0}, below_root3});
  EXPECT_EQ(told(found.judgement), Lines{"vertex_a.radius missed_separation masked rounding"});
}

// 8: touching at a vertex, in numbers that need no rounding: a tie, a contact, no flip.
TEST(HandWorked, TouchingIsContact) {
  const auto found = judged({{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 1});
  EXPECT_TRUE(found.truth.touching);
  EXPECT_TRUE(has_bit(found.exact->ties, Comparison::vertex_a_radius));
  EXPECT_TRUE(found.judgement.flips().empty());
}

// 9: a kernel whose bits are not the reference's: the fault is its own, and a wrong verdict counts the missed contact.
TEST(HandWorked, BitsThatAreNotTheReferencesAreAnImplementationFault) {
  const Query<float> q{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 2};
  const ExactTruth truth = exact_truth(q, true);
  const Reference chain = *AskedSphereTriangle(q, Opinion::second).chain(find_kernel("published"));
  EXPECT_EQ(chain.exact, chain.rounded->reference);
  const auto wrong = static_cast<ComparisonBits>(*chain.rounded->reference.bits | comparisons_of(Axis::plane));
  const Judgement judgement = judge(sphere_triangle_predicate(), truth, chain, outcome_of(wrong));
  EXPECT_EQ(told(judgement),
            (Lines{"verdict false_separation decisive implementation", "plane false_separation decisive implementation",
                   "plane.radius false_separation decisive implementation"}));
}

// 10: two broken links that cancel: the verdict is right, and both links are recorded.
TEST(HandWorked, LinksThatCancelLeaveTheVerdictRight) {
  const Query<float> q{{2, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, 1};
  const ExactTruth truth = exact_truth(q, true);
  const auto separated = static_cast<ComparisonBits>(truth.sides->strict | comparisons_of(Axis::vertex_a));
  const Judgement judgement =
      judge(sphere_triangle_predicate(), truth,
            Reference{outcome_of(truth.sides->strict), RoundedDecisions{outcome_of(separated), outcome_of(separated)}},
            outcome_of(separated));
  EXPECT_FALSE(judgement.verdict_flip);
  EXPECT_EQ(judgement.verdict_links, (LinkSet{Link::specification, Link::rounding}));
  // Relative to its own exact formulae the kernel's verdict did flip, and the axis that flipped it is decisive.
  EXPECT_EQ(told(judgement), (Lines{"vertex_a false_separation decisive rounding",
                                    "vertex_a.side_b false_separation decisive rounding"}));
}

// If the kernel wrongly says contact, an axis that flipped in the other direction cannot be the cause.
TEST(HandWorked, AFlipTheOtherWayIsMasked) {
  const Query<float> q{{-1, 2, 0}, {1, 2, 0}, {0, 3, 0}, {0, 0, 0}, 1};
  const ExactTruth truth = exact_truth(q, true);
  const ComparisonBits exact = truth.sides->strict;
  const ComparisonBits kernel = (exact & ~one_bit<ComparisonBits>(Comparison::edge_ab_radius)) |
                                one_bit<ComparisonBits>(Comparison::vertex_c_side_a);
  const Judgement judgement =
      judge(sphere_triangle_predicate(), truth,
            Reference{outcome_of(exact), RoundedDecisions{outcome_of(kernel), outcome_of(kernel)}}, outcome_of(kernel));
  EXPECT_EQ(told(judgement),
            (Lines{"verdict false_contact decisive rounding", "edge_ab missed_separation decisive rounding",
                   "vertex_c.side_a false_separation masked rounding",
                   "edge_ab.radius missed_separation decisive rounding"}));
}

TEST(Judge, InvalidTruthHasNoFlips) {
  const auto found = judged({{std::numeric_limits<float>::quiet_NaN(), 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 0, 0}, 1});
  EXPECT_EQ(found.truth.verdict, Verdict::invalid);
  EXPECT_TRUE(found.judgement.flips().empty());
  EXPECT_FALSE(found.squared_distance);
}

TEST(Judge, AKernelWithoutAReferenceIsUnattributed) {
  const Query<float> q{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 2};
  const Judgement judgement =
      judge(sphere_triangle_predicate(), exact_truth(q, true), std::nullopt, {Verdict::separated, std::nullopt});
  EXPECT_EQ(told(judgement), Lines{"verdict false_separation decisive unattributed"});
}

TEST(Judge, AnUndecidedKernelDoesNotFlip) {
  const Query<float> q{{1, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, 0, 0}, 2};
  EXPECT_TRUE(judge(sphere_triangle_predicate(), exact_truth(q, true), std::nullopt, {Verdict::undecided, std::nullopt})
                  .flips()
                  .empty());
}

}  // namespace
}  // namespace axiscert
