// The check that the library makes of itself passes on every instruction set, and refuses a library whose answers are
// not right, or whose floating-point modes are not the default ones.
#include "kernel/sphere_triangle/certified/steps.h"

#include <gtest/gtest.h>

#include "kernel/base/environment.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::certified {
namespace {

const Forms& forms_on(const std::string& target) {
  static const SimdTable<Forms> table([] { return chosen_forms(); });
  return table.on(target);
}

TEST(CertifiedSelfCheck, PassesOnEveryInstructionSet) {
  EXPECT_TRUE(passed_self_check());
  EXPECT_TRUE(answer_as_stored(exact_only_forms(), true));
  EXPECT_FALSE(answer_as_stored(exact_only_forms(), false))
      << "the conservative answers are those of the closed sphere";
  for (const std::string& target : simd_targets()) EXPECT_TRUE(answer_as_stored(forms_on(target), false)) << target;
}

TEST(CertifiedSelfCheck, RefusesOtherModes) {
  for (const std::string& target : simd_targets()) {
    for (const Rounding rounding : {Rounding::upward, Rounding::downward, Rounding::toward_zero}) {
      const FloatingEnvironment modes(rounding, false);
      EXPECT_FALSE(answer_as_stored(forms_on(target), false)) << target << ", rounding " << static_cast<int>(rounding);
    }
    const FloatingEnvironment modes(Rounding::nearest, true);
    EXPECT_FALSE(answer_as_stored(forms_on(target), false)) << target << ", flushed";
  }
}

// Forms with one wrong bit: in one lane of a block of one precision, in a pair, or where an answer is not marked
// invalid.
TEST(CertifiedSelfCheck, RefusesOneWrongBit) {
  const Forms right = exact_only_forms();
  ASSERT_TRUE(answer_as_stored(right, true));
  Forms faulty = right;
  faulty.pair32 = [](const float* triangle, const float* sphere, Question question, BlockAnswer& answer) noexcept {
    exact_only_forms().pair32(triangle, sphere, question, answer);
    answer.contact[0] ^= question == Question::open_sphere && sphere[3] == 0;
  };
  EXPECT_FALSE(answer_as_stored(faulty, true));
  faulty = right;
  faulty.pair64 = [](const double* triangle, const double* sphere, Question question, BlockAnswer& answer) noexcept {
    exact_only_forms().pair64(triangle, sphere, question, answer);
    answer.invalid[0] = 0;
  };
  EXPECT_FALSE(answer_as_stored(faulty, true));
  const std::string target = simd_targets().front();
  static const Forms best = forms_on(target);
  faulty = best;
  ASSERT_TRUE(answer_as_stored(faulty, false));
  faulty.block64 = [](const Block<double>& block, Question question, BlockAnswer& answer) noexcept {
    best.block64(block, question, answer);
    if (block.size > 50) answer.contact[0] ^= std::uint64_t{1} << 50;
  };
  EXPECT_FALSE(answer_as_stored(faulty, false));
}

}  // namespace
}  // namespace axiscert::certified
