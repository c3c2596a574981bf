// A batch of queries equals the queries of its positions, wherever it begins and whatever its length, on every
// instruction set.
#include <cstring>

#include "fuzz/queries/family_testing.h"
#include "fuzz/queries/lane_testing.h"
#include "fuzz/queries/source.h"

namespace axiscert {
namespace {

template <class Real>
class Filling : public testing::Test {};
TYPED_TEST_SUITE(Filling, Reals);
template <class Real>
class FillingLong : public testing::Test {};
TYPED_TEST_SUITE(FillingLong, Reals);
// Families of other predicates than sphere-triangle, which a sanitized build may take from another one.
template <class Real>
class FillingElsewhere : public testing::Test {};
TYPED_TEST_SUITE(FillingElsewhere, Reals);

std::vector<const Family*> own_families() { return families_of(sphere_triangle_predicate()); }
std::vector<const Family*> families_elsewhere() {
  std::vector<const Family*> found;
  for (const Family* family : families()) {
    if (&family->predicate() != &sphere_triangle_predicate()) found.push_back(family);
  }
  return found;
}

template <class Real>
std::string bytes_of(const Numbers<Real>& q) {
  return {reinterpret_cast<const char*>(q.data()), q.size() * sizeof(Real)};
}

constexpr std::uint64_t seed = 20261121;

// One of so many pairs of a count and an offset is asked, another for each family, in the quick test and in slow
// builds: the number has no factor in common with the numbers of either.
constexpr std::size_t few_pairs = 29;

TEST(Filling, MeetsEveryInstructionSetOfTheKernels) {
  std::vector<std::string> met;
  for_each_instruction_set([&](const std::string& target) { met.push_back(target); });
  for (const std::string& target : simd_targets()) {
    EXPECT_EQ(std::count(met.begin(), met.end(), target), 1) << target;
  }
}

// 64 is the block size of the families in lanes: its edges are crossed from both sides.
template <class Real>
void expect_fill_is_make(const std::vector<const Family*>& asked, std::size_t stride_of_pairs) {
  constexpr std::size_t most = 150;
  std::size_t begin_of_family = 0;
  for (const Family* family : asked) {
    const SourcePtr source = family_source(*family);
    std::vector<std::string> expected(2 * most);
    const std::uint64_t start = (std::uint64_t{1} << 32) - 100;  // the position's low word carries over
    for (std::size_t i = 0; i < expected.size(); ++i) {
      expected[i] = bytes_of(source->make<Real>(seed, start + i));
    }
    ++begin_of_family;
    for_each_instruction_set([&](const std::string& target) {
      QueryBatch<Real> batch(most, family->column_count());
      std::size_t pair = begin_of_family;
      for (const std::size_t count : {0, 1, 2, 3, 5, 7, 8, 9, 15, 16, 17, 31, 33, 63, 64, 65, 127, 128, 150}) {
        for (const std::size_t offset : {0, 1, 2, 3, 4, 7, 8, 13, 63, 64, 65, 149}) {
          if (pair++ % stride_of_pairs != 0) continue;
          source->fill(seed, start + offset, count, batch);
          ASSERT_EQ(batch.size(), count);
          for (std::size_t i = 0; i < count; ++i) {
            ASSERT_EQ(bytes_of(batch[i]), expected[offset + i])
                << family->name << ", " << target << ", seed " << seed << ", first " << start + offset << ", count "
                << count << ", query " << i;
          }
        }
      }
    });
  }
}

TYPED_TEST(Filling, IsMakeAtOffsetsAndCountsOnEveryInstructionSet) {
  expect_fill_is_make<TypeParam>(own_families(), few_pairs);
}
TYPED_TEST(FillingElsewhere, IsMakeAtOffsetsAndCountsOnEveryInstructionSet) {
  expect_fill_is_make<TypeParam>(families_elsewhere(), few_pairs);
}
TYPED_TEST(FillingLong, IsMakeAtEveryOffsetAndCountOnEveryInstructionSet) {
  const auto all = families();
  expect_fill_is_make<TypeParam>({all.begin(), all.end()}, TRIAL_DIVISOR == 1 ? 1 : few_pairs);
}

template <class Real>
void expect_nothing_past_the_batch(const std::vector<const Family*>& asked) {
  for (const Family* family : asked) {
    for (const std::size_t count : {1, 9, 63, 65}) {
      std::vector<std::vector<Real>> storage(family->column_count());
      MutableColumns<Real> columns{{}, count, storage.size()};
      for (std::size_t k = 0; k < storage.size(); ++k) {
        storage[k].assign(count + 80, Real(12345));
        columns.column[k] = storage[k].data() + 8;
      }
      family->fill(seed, 77, columns);
      for (const auto& column : storage) {
        for (std::size_t i = 0; i < column.size(); ++i) {
          if (i < 8 || i >= count + 8) {
            ASSERT_EQ(column[i], Real(12345)) << family->name << " wrote at " << i << " of " << count;
          }
        }
      }
    }
  }
}

TYPED_TEST(Filling, WritesNothingPastTheBatch) { expect_nothing_past_the_batch<TypeParam>(own_families()); }
TYPED_TEST(FillingElsewhere, WritesNothingPastTheBatch) {
  expect_nothing_past_the_batch<TypeParam>(families_elsewhere());
}

}  // namespace
}  // namespace axiscert
