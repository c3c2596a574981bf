// Tallies of real units: the same bytes in whatever order they were merged, and a round trip.
#include "fuzz/campaign/parts/tally_code.h"

#include <gtest/gtest.h>

#include <random>

#include "fuzz/campaign/parts/stretch_testing.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

// Tallies of many small units, with flips of every kind and leaders that tie, but no findings.
std::vector<Tally> real_tallies() {
  const Plan plan =
      small_plan({"published", "first-publication"}, {"tangent", "sliver", "tie", "repeated", "scale"}, 1);
  std::vector<Tally> tallies;
  for (const SourcePtr& source : plan.questions.sources) {
    for (const Precision precision : plan.questions.precisions) {
      for (std::uint64_t unit = 0; unit < 3; ++unit) {
        const UnitResult done = run_unit(plan, *source, precision, unit, 1200 / TRIAL_DIVISOR);
        tallies.insert(tallies.end(), done.tallies.begin(), done.tallies.end());
      }
    }
  }
  return tallies;
}

const std::vector<Tally>& tallies() {
  static const std::vector<Tally> made = [] {
    std::vector<Tally> all = real_tallies();
    // Findings come from plug-ins only.
    for (std::size_t i = 0; i < all.size(); ++i) {
      count_finding(all[i], static_cast<FindingKind>(i % finding_kind_count), i / 2, "of " + std::to_string(i));
    }
    return all;
  }();
  return made;
}

TEST(TallyCode, BytesGiveTheTallyAgain) {
  for (const Tally& tally : tallies()) {
    const std::string bytes = encode(tally);
    EXPECT_EQ(encode(decode_tally(bytes, sphere_triangle_predicate())), bytes);
  }
}

TEST(TallyCode, MergingIsCommutative) {
  const auto& all = tallies();
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    Tally ab = all[i], ba = all[i + 1];
    ab.merge(all[i + 1]);
    ba.merge(all[i]);
    EXPECT_EQ(encode(ab), encode(ba)) << i;
  }
}

TEST(TallyCode, MergingIsAssociative) {
  const auto& all = tallies();
  for (std::size_t i = 0; i + 2 < all.size(); ++i) {
    Tally left = all[i], right = all[i + 1], whole = all[i];
    left.merge(all[i + 1]);
    left.merge(all[i + 2]);
    right.merge(all[i + 2]);
    whole.merge(right);
    EXPECT_EQ(encode(left), encode(whole)) << i;
  }
}

// Any order, any grouping, and a round trip through bytes for any of the parts.
TEST(TallyCode, EveryTreeOfMergesGivesTheSameBytes) {
  constexpr std::uint64_t seed = 20261121;
  std::mt19937_64 random(seed);
  std::string expected;
  for (int tree = 0; tree < 60; ++tree) {
    std::vector<Tally> parts = tallies();
    while (parts.size() > 1) {
      std::swap(parts[random() % parts.size()], parts.back());
      Tally last = random() % 2 == 0 ? parts.back() : decode_tally(encode(parts.back()), sphere_triangle_predicate());
      parts.pop_back();
      parts[random() % parts.size()].merge(last);
    }
    if (expected.empty()) expected = encode(parts[0]);
    ASSERT_EQ(encode(parts[0]), expected) << "tree " << tree << " of seed " << seed;
  }
}

TEST(TallyCode, OtherBytesAreRefused) {
  const std::string bytes = encode(tallies()[0]);
  EXPECT_THROW(decode_tally(bytes.substr(0, bytes.size() / 2), sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_tally("", sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_tally(encode(Costs{}), sphere_triangle_predicate()), Error);
  EXPECT_THROW(decode_costs(bytes), Error);
}

}  // namespace
}  // namespace axiscert
