// Every instruction set against the scalar reference, bit for bit: each lane, partial vectors at the end of a batch,
// garbage in the other lanes.
#include "kernel/sphere_triangle/forms/simd.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/random_testing.h"
#include "kernel/sources_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing_support::random_query, testing_support::same;

template <class Real>
Query<Real> garbage(std::size_t i) {
  constexpr Real inf = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
  std::array<Real, coordinate_count> v;
  v.fill(i % 3 == 0 ? inf : i % 3 == 1 ? nan : std::numeric_limits<Real>::max());
  return from_coordinates(v);
}

template <class Real>
void expect_same_answers(const QueryBatch<Real>& batch, const Kernel& kernel, const std::string& target) {
  const std::size_t n = batch.size();
  const auto scalar = reference_implementation<Real>(formulae_of(kernel), kernel.arithmetic, kernel.strictness);
  const auto kernel_there = kernel.on<Real>(target);
  std::vector<Verdict> expected(n), found(n + 64, Verdict::invalid);
  scalar.verdicts(batch.columns(), expected.data());
  kernel_there.verdicts(batch.columns(), found.data());
  for (std::size_t i = n; i < found.size(); ++i) ASSERT_EQ(found[i], Verdict::invalid) << "wrote past the batch";
  Answers<Real> reference, answers;
  reference.resize(n, comparison_count);
  answers.resize(n, comparison_count);
  scalar.explain(batch.columns(), reference);
  kernel_there.explain(batch.columns(), answers);
  for (std::size_t i = 0; i < n; ++i) {
    ASSERT_EQ(found[i], expected[i]) << kernel.id << " " << target << " query " << i << " of " << n;
    ASSERT_EQ(answers.bits[i], reference.bits[i]) << kernel.id << " " << target << " query " << i << " of " << n;
    ASSERT_EQ(verdict_of(axes_of(answers.bits[i])), found[i]) << kernel.id << " " << target << " query " << i;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      ASSERT_TRUE(same(answers.lhs[k][i], reference.lhs[k][i]) && same(answers.rhs[k][i], reference.rhs[k][i]))
          << kernel.id << " " << target << " query " << i << " " << comparisons[k].name;
    }
  }
}

// Each kernel that claims the scalar reference bit for bit, on each target where it has a form of its own.
template <class Body>
void for_each_own_form(Body&& body) {
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate != &sphere_triangle_predicate()) continue;
    if (!kernel.is_reference || kernel.exposes != Exposure::sides) continue;
    if (!kernel.has_simd) body(kernel, std::string(scalar_target));
    else
      for (const std::string& target : simd_targets()) body(kernel, target);
  }
}

template <class Real>
class SimdTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(SimdTest, Reals);
template <class Real>
class SimdTestLong : public testing::Test {};
TYPED_TEST_SUITE(SimdTestLong, Reals);

// A build in which the trials are divided is slow: its quick tests are about the memory that forms touch, of which
// fewer queries say as much; its long tests ask all.
constexpr bool is_slow = TRIAL_DIVISOR != 1;

TYPED_TEST(SimdTest, MachineHasAnInstructionSetToTest) { EXPECT_FALSE(simd_targets().empty()); }

TEST(SimdForms, EveryOneThatIsDefinedIsListed) {
  for (const auto& [formulae, file] :
       testing_support::defined_in("kernel/sphere_triangle/forms", R"(const SimdForms& simd_(\w+)\(\) \{)")) {
    bool is_listed = false;
#define AXISCERT_LOOK(set, type, kind) is_listed |= formulae == #set && has_simd_form(Formulae::set);
    AXISCERT_FORMULAE(AXISCERT_LOOK)
#undef AXISCERT_LOOK
    EXPECT_TRUE(is_listed) << file << " defines simd_" << formulae
                           << ", for which the list of kernel/sphere_triangle/forms/simd.cpp lacks X(" << formulae
                           << ")";
  }
}

template <class Real>
void expect_agreement_on_random_bits(int count) {
  constexpr std::uint64_t seed = 20101230;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(count, coordinate_count);
  for (int i = 0; i < count; ++i) batch.push_back(random_query<Real>(random, i % 2 == 1));
  for_each_own_form(
      [&](const Kernel& kernel, const std::string& target) { expect_same_answers(batch, kernel, target); });
}

TYPED_TEST(SimdTest, AgreesWithTheReferenceOnRandomAndOnArbitraryBits) {
  expect_agreement_on_random_bits<TypeParam>(is_slow ? 500 : 20000);
}
TYPED_TEST(SimdTestLong, AgreesWithTheReferenceOnRandomAndOnArbitraryBits) {
  if (is_slow) expect_agreement_on_random_bits<TypeParam>(20000);
}

// Every length of a batch, with the query in every place, or in the first, the middle and the last.
template <class Real>
void expect_agreement_in_lanes(bool every_place) {
  std::mt19937_64 random(7);
  for (std::size_t size = 1; size <= 35; ++size) {
    for (std::size_t place = 0; place < size; ++place) {
      if (!every_place && place != 0 && place != size / 2 && place != size - 1) continue;
      QueryBatch<Real> batch(size, coordinate_count);
      for (std::size_t i = 0; i < size; ++i) {
        batch.push_back(i == place ? random_query<Real>(random, false) : garbage<Real>(i));
      }
      for_each_own_form([&](const Kernel& kernel, const std::string& target) {
        if (kernel.strictness == Strictness::strict) expect_same_answers(batch, kernel, target);
      });
    }
  }
}

TYPED_TEST(SimdTest, EveryLaneAndEveryTailLengthWithGarbageInTheOthers) {
  expect_agreement_in_lanes<TypeParam>(!is_slow);
}
TYPED_TEST(SimdTestLong, EveryLaneAndEveryTailLengthWithGarbageInTheOthers) {
  if (is_slow) expect_agreement_in_lanes<TypeParam>(true);
}

}  // namespace
}  // namespace axiscert
