// Called kernels: they are called as their ids say, and claim only what still holds then.
#include "kernel/registry/called.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <random>

#include "kernel/base/error.h"
#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::random_query, testing_support::same, testing_support::sides_in;

TEST(Called, AnIdHasOneSpellingAndOneKernel) {
  const Kernel& kernel = find_kernel("certified@FLUSHED,Scalar,downward");
  EXPECT_EQ(kernel.id, "certified@scalar,downward,flushed");
  EXPECT_EQ(&kernel, &find_kernel("certified@scalar,downward,flushed"));
  EXPECT_EQ(find_kernel("published+fma@toward-zero").id, "published+fma@toward-zero");
  for (const std::string& target : available_targets()) {
    EXPECT_EQ(find_kernel("certified@" + target).call, Call{.target = target});
  }
}

TEST(Called, WhatCannotBeIsRefusedWithWhatCan) {
  const std::string best = available_targets().front();
  const std::pair<std::string, std::string> refusals[] = {
      {"certified@", "a word is missing after '@' or ','; instruction sets here: " + best},
      {"certified@MMX", "'MMX' is not a way to call a kernel"},
      {"certified@upward@flushed", "; modes: upward, downward, toward-zero, flushed"},
      {"certified@upward,", "a word is missing"},
      {"certified@flushed,Flushed", "'Flushed' appears twice"},
      {"certified@" + best + ",scalar," + best, "two instruction sets"},
      {"certified@upward,toward-zero", "two directions of rounding"},
      {"ladder-3@" + best, "ladder-3 has the same instructions on every target"},
      {"nosuch@upward", "unknown kernel 'nosuch'"},
      {"fault/nosuch@upward", "unknown kernel 'fault/nosuch'"},
  };
  for (const auto& [id, why] : refusals) {
    try {
      find_kernel(id);
      ADD_FAILURE() << id << " was found";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find(id.substr(0, id.find('@'))), std::string::npos) << e.what();
    }
  }
}

// The target and the modes with which each function of a kernel was called.
struct SeenCalls {
  std::string target;
  std::vector<std::pair<int, bool>> modes;  // direction of rounding, whether subnormal numbers are zero

  void look() {
    volatile float tiny = std::numeric_limits<float>::min();
    volatile float half = tiny * 0.5f;
    modes.emplace_back(std::fegetround(), half == 0);
  }
};

Kernel watching(SeenCalls& seen) {
  Kernel kernel;
  kernel.id = "watching";
  kernel.predicate = &sphere_triangle_predicate();
  kernel.formulae = "published";
  kernel.has_simd = true;
  kernel.binary32 = [&seen](std::string_view target) {
    seen.target = target;
    Implementation<float> implementation{[&seen](const auto&, Verdict*) { seen.look(); }};
    implementation.explain = [&seen](const auto&, Answers<float>&) { seen.look(); };
    implementation.bits = [&seen](const auto&, ComparisonBits*) { seen.look(); };
    return implementation;
  };
  return kernel;
}

TEST(Called, EveryFunctionIsCalledAsTheIdSays) {
  SeenCalls seen;
  const Kernel own = watching(seen);
  const auto call = [&](const std::string& words) {
    const Kernel kernel = called(own, words);
    EXPECT_EQ(kernel.binary64, nullptr) << "it has none";
    seen.modes.clear();
    const Implementation<float> implementation = kernel.on<float>("asked");
    const QueryBatch<float> batch(0, coordinate_count);
    Answers<float> answers;
    implementation.verdicts(batch.columns(), nullptr);
    implementation.explain(batch.columns(), answers);
    implementation.bits(batch.columns(), nullptr);
    return seen.modes;
  };
  const auto three_times = [](int rounding, bool flush) { return std::vector(3, std::pair(rounding, flush)); };
  EXPECT_EQ(call("flushed"), three_times(FE_TONEAREST, true));
  EXPECT_EQ(seen.target, "asked");
  EXPECT_EQ(call("upward,scalar"), three_times(FE_UPWARD, false));
  EXPECT_EQ(seen.target, "scalar");
  EXPECT_EQ(call("downward"), three_times(FE_DOWNWARD, false));
  EXPECT_EQ(call("toward-zero,flushed"), three_times(FE_TOWARDZERO, true));
  EXPECT_EQ(call("scalar"), three_times(FE_TONEAREST, false));
}

TEST(Called, InAModeItClaimsNoBitsOfTheReference) {
  const Kernel &plain = find_kernel("published@scalar"), &upward = find_kernel("published@scalar,upward");
  EXPECT_TRUE(plain.is_reference);
  EXPECT_FALSE(upward.is_reference);
  EXPECT_FALSE(find_kernel("published@flushed").is_reference);
  EXPECT_EQ(upward.formulae, "published");
  EXPECT_EQ(upward.exposes, Exposure::sides);
  EXPECT_FALSE(plain.takes_arithmetic);
}

// The modes reach the computation: on each instruction set the sides are those of the arithmetic that sets the modes
// itself.
template <class Real>
void expect_sides_of_the_arithmetic(const std::string& mode, const std::string& arithmetic) {
  constexpr int seed = 61;
  const Kernel& expected = find_kernel("published+" + arithmetic);
  for (const std::string& target : available_targets()) {
    const Kernel& kernel = find_kernel("published@" + target + "," + mode);
    std::mt19937_64 random(seed);
    for (int i = 0; i < 500; ++i) {
      const auto q = random_query<Real>(random, i % 2 == 1);
      const auto own = sides_in(kernel, q), theirs = sides_in(expected, q);
      for (std::size_t k = 0; k < comparison_count; ++k) {
        ASSERT_TRUE(same(own.lhs[k], theirs.lhs[k]) && same(own.rhs[k], theirs.rhs[k]))
            << kernel.id << ", query " << i << " of seed " << seed << " " << comparisons[k].name;
      }
      answer(kernel, q);  // also checks that the bits make the verdict
    }
  }
}

TEST(Called, TheSidesAreThoseOfTheArithmeticThatSetsTheModeItself) {
  for (const auto& [mode, arithmetic] :
       {std::pair("upward", "up"), {"downward", "down"}, {"toward-zero", "chop"}, {"flushed", "ftz"}}) {
    expect_sides_of_the_arithmetic<float>(mode, arithmetic);
    expect_sides_of_the_arithmetic<double>(mode, arithmetic);
  }
}

}  // namespace
}  // namespace axiscert
