// The proved bound of box-box/cofactor (docs/boxes.md) on the families of rotations that were rounded: no wrong verdict
// is deeper, and how near the deepest come to it. The textbook breaks it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/boxes/measures.h"
#include "exact/boxes/boxes_testing.h"
#include "exact/boxes/cofactor_bound.h"
#include "fuzz/boxes/parts.h"
#include "fuzz/files/corpus.h"
#include "kernel/boxes/relative.h"

namespace axiscert::boxes {
namespace {

constexpr std::uint64_t bound_seed = 20261124;

// A kernel's wrong verdicts: how many, and the greatest part of the bound that one has.
struct BoundUse {
  int missed = 0, phantom = 0;
  double of_missed = 0, of_phantom = 0;            // depth / bound
  double deepest_missed = 0, deepest_phantom = 0;  // in u of the scene
};

template <class F, class Real>
bool is_separated_by(const BoxPair<Real>& q) {
  return bits_of<F, Real>(q, [](std::size_t, Real, Real) {}) != 0;
}

// A pair's exact depth, and the most that the bound allows a wrong verdict on it, both as parts of the scene.
struct BoundedDepth {
  bool contact;
  double defect, depth, bound;
};
BoundedDepth bounded_depth(const ExactPair& exact, double u) {
  const bool contact = squared_distance(exact) <= 0;
  const double defect = std::max(orthonormality_defect(exact.a), orthonormality_defect(exact.b)).get_d();
  const CofactorBound bound = cofactor_bound(u, defect);
  return {contact, defect, rounded_depth(exact_depth(exact)), contact ? bound.missed : bound.phantom};
}

template <class F, class Real>
void add_use(const Family& family, std::uint64_t queries, BoundUse& use) {
  const double u = std::ldexp(1.0, -std::numeric_limits<Real>::digits);
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<Real> numbers = family.make<Real>(bound_seed, position);
    const auto q = MatrixBoxes::problem<Real>([&](std::size_t k) { return numbers[k]; });
    const bool said_apart = is_separated_by<F>(q);
    const ExactPair exact = exactly(q);
    if (said_apart == (squared_distance(exact) > 0)) continue;
    const BoundedDepth wrong = bounded_depth(exact, u);
    ASSERT_LE(wrong.defect, 0x1p-10) << family.name << " at " << position;
    const double part = wrong.depth / wrong.bound;
    if (said_apart) {
      ++use.missed;
      use.of_missed = std::max(use.of_missed, part);
      use.deepest_missed = std::max(use.deepest_missed, wrong.depth / u);
    } else {
      ++use.phantom;
      use.of_phantom = std::max(use.of_phantom, part);
      use.deepest_phantom = std::max(use.deepest_phantom, wrong.depth / u);
    }
  }
}

template <class F, class Real>
BoundUse bound_use(std::uint64_t queries) {
  BoundUse use;
  for (const char* name : {"general", "tangent", "stacked", "resting", "crossed", "edge_edge", "vertex_face",
                           "parallel", "thin", "flat", "far", "stack", "pile", "ramp", "beams", "corridor"}) {
    add_use<F, Real>(find_family(std::string("box-box/") + name), queries, use);
  }
  return use;
}

template <class Real>
void expect_within_the_bound(std::uint64_t queries) {
  const BoundUse use = bound_use<Cofactor, Real>(queries);
  SCOPED_TRACE(testing::Message() << use.missed << " missed, deepest " << use.deepest_missed << " u; " << use.phantom
                                  << " phantom, farthest " << use.deepest_phantom << " u; seed " << bound_seed);
  EXPECT_LE(use.of_missed, 1);
  EXPECT_LE(use.of_phantom, 1);
  EXPECT_GT(use.missed, 0);
  EXPECT_GT(use.phantom, 0);
  EXPECT_GT(use.of_missed, 0.01) << "a bound a hundred times too wide says little";
  testing::Test::RecordProperty("missed_part_of_bound", std::to_string(use.of_missed));
  testing::Test::RecordProperty("phantom_part_of_bound", std::to_string(use.of_phantom));
}

TEST(CofactorBoundOnFamilies, NoWrongVerdictIsDeeper) {
  expect_within_the_bound<float>(60);
  expect_within_the_bound<double>(40);
}
TEST(CofactorBoundOnFamiliesLong, NoWrongVerdictIsDeeper) {
  expect_within_the_bound<float>(20000 / TRIAL_DIVISOR);
  expect_within_the_bound<double>(10000 / TRIAL_DIVISOR);
}

// The planted fault of this test: the textbook's misses are thousands of times as deep.
TEST(CofactorBoundOnFamilies, TheTextbookBreaksIt) {
  BoundUse use;
  add_use<Textbook, float>(find_family("box-box/resting"), 60, use);
  EXPECT_GT(use.of_missed, 100);
}

// The entries of the corpus that a search of an hour found.
TEST(CofactorBoundOnFamilies, TheWorstThatASearchFoundIsWithinIt) {
  int entries = 0;
  for (const CorpusEntry& entry : read_corpus(SOURCE_FOLDER "/fuzz/corpus")) {
    if (!entry.stored.id.starts_with("cofactor-")) continue;
    const auto& numbers = std::get<Numbers<float>>(entry.stored.numbers);
    const auto q = MatrixBoxes::problem<float>([&](std::size_t k) { return numbers[k]; });
    const BoundedDepth worst = bounded_depth(exactly(q), std::ldexp(1.0, -std::numeric_limits<float>::digits));
    EXPECT_EQ(is_separated_by<Cofactor>(q), worst.contact) << entry.stored.id;
    EXPECT_LE(worst.depth, worst.bound) << entry.stored.id;
    ++entries;
  }
  EXPECT_EQ(entries, 2);
}

}  // namespace
}  // namespace axiscert::boxes
