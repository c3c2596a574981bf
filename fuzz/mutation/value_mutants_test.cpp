// Mutants with a fault of a value have the fault that they name, in every magnitude.
#include <gtest/gtest.h>

#include <set>

#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "kernel/mutants/mutant.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

constexpr std::uint64_t value_seed = 7;

// The bits of a mutant on the first queries of every family.
template <class Real>
std::vector<ComparisonBits> bits_everywhere(const mutants::Mutant& mutant, bool takes_radius = false, Real least = 0) {
  std::vector<ComparisonBits> all;
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    QueryBatch<Real> batch(100, coordinate_count);
    batch.resize(100);
    family->fill(value_seed, 0, batch.mutable_columns());
    if (takes_radius) {
      Real* radius = batch.mutable_columns().column[coordinate_count - 1];
      for (std::size_t i = 0; i < batch.size(); ++i) radius[i] = radius[i] < least ? least : radius[i];
    }
    std::array<ComparisonBits, 100> bits;
    mutants::mutant_bits(mutant, batch.columns(), bits.data());
    all.insert(all.end(), bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(batch.size()));
  }
  return all;
}

TEST(ValueMutants, HaveTheFaultThatTheyName) {
  mutants::Mutant none;
  // The queries here are of the static test; moving_mutation_test.cpp asks the mutants of motions.
  for (const std::string_view base : {"nonstrict", "reduced-nonstrict"}) {
    none.id = base;
    const std::string of(std::string(base) + "~");
    const auto bits = [&](const std::string& id) { return bits_everywhere<float>(mutants::find_mutant(of + id)); };
    // A radius below 0.25 is 0.25.
    EXPECT_EQ(bits("clamp:r:0.25"), bits_everywhere<float>(none, true, 0.25f)) << base << " seed " << value_seed;
    EXPECT_NE(bits("clamp:r:0.25"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
    // The early answer on a small area is there in two forms.
    EXPECT_EQ(bits("early-contact:v:1e-10"), bits("small-area:contact")) << base << " seed " << value_seed;
    EXPECT_EQ(bits("early-separated:v:1e-10"), bits("small-area:separated")) << base << " seed " << value_seed;
    // One side plus a millionth is the fault of a comparison that needs less.
    EXPECT_EQ(bits("plus:edge_ab.radius:1e-06"), bits("slack:edge_ab.radius")) << base << " seed " << value_seed;
    // Half an ulp of itself is lost, two are not.
    EXPECT_EQ(bits("plus-relative:rr:1e-08"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
    EXPECT_NE(bits("plus-relative:rr:1e-06"), bits_everywhere<float>(none)) << base << " seed " << value_seed;
  }
}

TEST(ValueMutants, AreEachThereInEveryMagnitude) {
  const auto all = mutants::value_mutants_of("nonstrict", mutants::default_magnitudes);
  std::set<std::string> ids;
  for (const mutants::Mutant* m : all) {
    EXPECT_TRUE(ids.insert(m->id).second) << m->id;
    EXPECT_EQ(&mutants::find_mutant(m->id), m) << m->id;
    EXPECT_NE(bits_everywhere<double>(*m).size(), 0u);
  }
  EXPECT_EQ(all.size(), 7u * (7 * 12 + 6));
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:r:0"), Error);
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:r:1e-2x"), Error);
  EXPECT_THROW(mutants::find_mutant("nonstrict~clamp:verdict:0.1"), Error);
  EXPECT_THROW(mutants::value_mutants_of("nonstrict", std::array{-1.0}), Error);
}

}  // namespace
}  // namespace axiscert
