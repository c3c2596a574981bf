// The forms of the kernels of two boxes: on every instruction set bit for bit the scalar one, and the early answer the
// textbook's verdict.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "kernel/ask.h"
#include "kernel/boxes/names.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::boxes {
namespace {

using testing_support::same;

constexpr std::size_t matrix_columns = 30;

template <class Real>
Reply<Real> asked_boxes(std::string_view id, const QueryBatch<Real>& batch, std::string_view target = scalar_target) {
  Reply<Real> reply;
  ask(find_kernel("box-box/" + std::string(id)).on<Real>(target), batch.columns(), reply);
  return reply;
}

// Numbers in [-1, 1), half extents without their sign; every third query of arbitrary bits, every fourth of small
// integers.
template <class Real>
QueryBatch<Real> mixed_boxes(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(count, matrix_columns);
  for (std::size_t i = 0; i < count; ++i) {
    Numbers<Real> numbers(matrix_columns);
    for (std::size_t k = 0; k < matrix_columns; ++k) {
      const std::uint64_t bits = random();
      Real& x = numbers[k];
      if (i % 3 == 2) x = std::bit_cast<Real>(static_cast<testing_support::Bits<Real>>(bits));
      else if (i % 4 == 1) x = static_cast<Real>(static_cast<int>(bits % 7) - 3);
      else x = static_cast<Real>(static_cast<std::int64_t>(bits) >> 11) * Real(0x1p-52);
      if (k % 15 >= 3 && k % 15 < 6) x = std::fabs(x) / 4;
    }
    batch.push_back(numbers);
  }
  return batch;
}

template <class Real>
void expect_same_boxes(std::string_view id, const QueryBatch<Real>& batch, const std::string& target) {
  const Reply<Real> scalar = asked_boxes(id, batch), found = asked_boxes(id, batch, target);
  ASSERT_EQ(found.verdicts, scalar.verdicts) << id << " " << target;
  ASSERT_TRUE(scalar.has_bits && found.has_bits);
  ASSERT_EQ(found.answers.bits, scalar.answers.bits) << id << " " << target;
  for (std::size_t k = 0; k < axis_count; ++k) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_TRUE(same(found.answers.lhs[k][i], scalar.answers.lhs[k][i]) &&
                  same(found.answers.rhs[k][i], scalar.answers.rhs[k][i]))
          << id << " " << target << " query " << i << " " << axis_names[k];
    }
  }
}

template <class Real>
class BoxSimd : public testing::Test {};
using BoxReals = testing::Types<float, double>;
TYPED_TEST_SUITE(BoxSimd, BoxReals);

TYPED_TEST(BoxSimd, AgreesWithTheScalarFormToTheBitForEveryTail) {
  for (const std::string& target : simd_targets()) {
    for (const std::string_view id : {"textbook", "cofactor"}) {
      ASSERT_TRUE(find_kernel("box-box/" + std::string(id)).has_simd);
      expect_same_boxes(id, mixed_boxes<TypeParam>(6000, 20261124), target);
      for (std::size_t size = 1; size <= 35; ++size) expect_same_boxes(id, mixed_boxes<TypeParam>(size, size), target);
    }
  }
}

// The comparison above does tell forms apart.
TYPED_TEST(BoxSimd, TheTextbookIsNotTheFormWithCofactors) {
  const QueryBatch<TypeParam> batch = mixed_boxes<TypeParam>(6000, 20261124);
  const std::string target = simd_targets().front();
  EXPECT_NE(asked_boxes("textbook", batch, target).answers.bits, asked_boxes("cofactor", batch).answers.bits);
}

TYPED_TEST(BoxSimd, TheEarlyAnswerIsTheTextbooksVerdict) {
  const QueryBatch<TypeParam> batch = mixed_boxes<TypeParam>(6000, 5);
  const std::vector<Verdict> whole = asked_boxes("textbook", batch).verdicts;
  EXPECT_EQ(asked_boxes("textbook-early", batch).verdicts, whole);
  EXPECT_GT(std::count(whole.begin(), whole.end(), Verdict::contact), 600);
  EXPECT_GT(std::count(whole.begin(), whole.end(), Verdict::separated), 600);
}

}  // namespace
}  // namespace axiscert::boxes
