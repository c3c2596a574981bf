// Rounding modes and flushing: their effect on a kernel, compared with directed rounding in software, and that no
// kernel leaves them changed.
#include "kernel/base/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kernel/sphere_triangle/forms/formulae_types.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/queries_testing.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::random_query, testing_support::sides_in;

// A float whose operations round in a given direction, computed in double: every result in double comes with the sign
// of its rounding error.
template <Rounding direction>
struct DirectedFloat {
  float value;

  static DirectedFloat from(double near, double rest) {
    float f = static_cast<float>(near);
    // The exact value is near + rest; f may lie on either side of it.
    const double over = static_cast<double>(f) - near;
    const bool above = over > 0 || (over == 0 && rest < 0), below = over < 0 || (over == 0 && rest > 0);
    const bool down = direction == Rounding::downward || (direction == Rounding::toward_zero && near > 0);
    if (above && down) f = std::nextafter(f, -INFINITY);
    if (below && !down) f = std::nextafter(f, INFINITY);
    return {f};
  }
  friend DirectedFloat operator+(DirectedFloat a, DirectedFloat b) {
    const double x = a.value, y = b.value, sum = x + y, of_y = sum - x;
    return from(sum, (x - (sum - of_y)) + (y - of_y));
  }
  friend DirectedFloat operator-(DirectedFloat a, DirectedFloat b) { return a + DirectedFloat{-b.value}; }
  friend DirectedFloat operator*(DirectedFloat a, DirectedFloat b) { return from(double(a.value) * b.value, 0); }
  friend DirectedFloat operator/(DirectedFloat a, DirectedFloat b) {
    const double quotient = double(a.value) / b.value;
    return from(quotient, std::fma(-quotient, b.value, a.value) * (b.value < 0 ? -1 : 1));
  }
  friend DirectedFloat square_root(DirectedFloat a) {
    const double root = std::sqrt(double(a.value));
    return from(root, std::fma(-root, root, a.value));
  }
  friend DirectedFloat magnitude(DirectedFloat a) { return {std::fabs(a.value)}; }
};

template <class F, Rounding direction>
void expect_rounded(const char* id, Formulae formulae, Arithmetic arithmetic) {
  constexpr int seed = 51;
  std::mt19937_64 random(seed);
  for (int i = 0; i < 3000; ++i) {
    const auto q = random_query<float>(random, false);
    Sides<float> found;
    reference(formulae, arithmetic, Strictness::strict, q, &found);
    const auto expected =
        sides_of<F>(problem_as<DirectedFloat<direction>>(q, [](float x) { return DirectedFloat<direction>{x}; }));
    for (std::size_t k = 0; k < comparison_count; ++k) {
      ASSERT_EQ(found.lhs[k], expected.lhs[k].value)
          << id << ", query " << i << " of seed " << seed << " " << comparisons[k].name;
      ASSERT_EQ(found.rhs[k], expected.rhs[k].value)
          << id << ", query " << i << " of seed " << seed << " " << comparisons[k].name;
    }
  }
}

TEST(RoundingModes, EveryOperationIsRoundedInItsDirection) {
  using portable::PublishedFormulae, rungs::Ladder0, rungs::Ladder6;
  expect_rounded<PublishedFormulae, Rounding::upward>("published+up", Formulae::published, Arithmetic::up);
  expect_rounded<PublishedFormulae, Rounding::downward>("published+down", Formulae::published, Arithmetic::down);
  expect_rounded<PublishedFormulae, Rounding::toward_zero>("published+chop", Formulae::published, Arithmetic::chop);
  expect_rounded<Ladder0, Rounding::upward>("ladder-0+up", Formulae::ladder_0, Arithmetic::up);
  expect_rounded<Ladder0, Rounding::downward>("ladder-0+down", Formulae::ladder_0, Arithmetic::down);
  expect_rounded<Ladder0, Rounding::toward_zero>("ladder-0+chop", Formulae::ladder_0, Arithmetic::chop);
  expect_rounded<Ladder6, Rounding::upward>("ladder-6+up", Formulae::ladder_6, Arithmetic::up);
}

// Subnormal results (the squares, in the first query) and operands (the coordinates, in the second) are zero.
TEST(FlushToZero, SubnormalNumbersBecomeZero) {
  for (const float s : {0x1p-70f, 0x1p-140f}) {
    const Query<float> q{{0, 0, 0}, {4 * s, 0, 0}, {0, 4 * s, 0}, {0, 0, 3 * s}, s};
    const auto flushed = sides_in(find_kernel("published+ftz"), q);
    for (std::size_t k = 0; k < comparison_count; ++k) EXPECT_EQ(flushed.lhs[k], 0) << comparisons[k].name;
  }
  const Query<float> small{{0x1p-70f, 0, 0}, {0x1p-69f, 0, 0}, {0x1p-69f, 0x1p-70f, 0}, {0, 0, 0}, 0};
  EXPECT_GT(sides_in(find_kernel("published"), small).lhs[1], 0) << "gradual underflow without it";
  EXPECT_EQ(answer(find_kernel("published"), small).verdict, Verdict::separated);
  EXPECT_EQ(answer(find_kernel("published+ftz"), small).verdict, Verdict::contact);
  const Query<double> wide{{0x1p-520, 0, 0}, {0x1p-519, 0, 0}, {0x1p-519, 0x1p-520, 0}, {0, 0, 0}, 0};
  EXPECT_EQ(answer(find_kernel("published"), wide).verdict, Verdict::separated);
  EXPECT_EQ(answer(find_kernel("published+ftz"), wide).verdict, Verdict::contact);
}

// The rounding mode that the C library reports and, with SSE2, the control register itself without its status flags.
struct Modes {
  int rounding = std::fegetround();
#if defined(__SSE2__)
  unsigned control = _mm_getcsr() & ~0x3fu;
#endif
  bool operator==(const Modes&) const = default;
};

template <class Real>
void expect_modes_kept(const Kernel& kernel, std::string_view target) {
  if (!kernel.has(precision_of<Real>)) return;
  const Modes before;
  constexpr Real tiny = std::numeric_limits<Real>::denorm_min(), huge = std::numeric_limits<Real>::max();
  for (const Real s : {Real(1), tiny, huge, std::numeric_limits<Real>::quiet_NaN()}) {
    answer<Real>(kernel, {{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}, s}, target);
    ASSERT_EQ(before, Modes()) << kernel.id << " on " << target;
  }
}

TEST(Environment, NoKernelLeavesAModeBehind) {
  for (const Kernel& kernel : kernels()) {
    if (kernel.predicate != &sphere_triangle_predicate()) continue;
    for (const std::string& target : kernel.has_simd ? available_targets() : std::vector{std::string(scalar_target)}) {
      expect_modes_kept<float>(kernel, target);
      expect_modes_kept<double>(kernel, target);
    }
    for (const ArithmeticInfo& arithmetic : arithmetics()) {
      if (!kernel.takes_arithmetic) continue;
      const Kernel& composed = find_kernel(kernel.id + "+" + arithmetic.name);
      expect_modes_kept<float>(composed, scalar_target);
      expect_modes_kept<double>(composed, scalar_target);
    }
  }
}

TEST(Environment, AScopeRestoresWhatItsCallerHadSet) {
  const Modes outside;
  {
    const FloatingEnvironment caller(Rounding::upward, true);
    const Modes inside;
    EXPECT_FALSE(inside == outside);
    {
      const FloatingEnvironment callee(Rounding::toward_zero, false);
      EXPECT_EQ(std::fegetround(), FE_TOWARDZERO);
    }
    EXPECT_EQ(inside, Modes());
    { const FloatingEnvironment callee(Rounding::nearest, true); }
    EXPECT_EQ(inside, Modes());
  }
  EXPECT_EQ(outside, Modes());
#if defined(__SSE2__)
  // A caller that has set one of the two flush bits keeps only that one.
  const unsigned flush_results = 0x8000;
  _mm_setcsr(_mm_getcsr() | flush_results);
  const Modes half;
  { const FloatingEnvironment callee(Rounding::nearest, true); }
  const bool kept = half == Modes();
  _mm_setcsr(_mm_getcsr() & ~flush_results);
  EXPECT_TRUE(kept);
#endif
}

// The status flags tell whether a reference stayed in range, so a scope leaves them raised.
TEST(Environment, FlagsRaisedInAScopeStayRaised) {
  std::feclearexcept(FE_ALL_EXCEPT);
  const float huge = 0x1p100f;
  answer<float>(find_kernel("published+up"), {{huge, 0, 0}, {0, huge, 0}, {0, 0, huge}, {0, 0, 0}, 1});
  EXPECT_TRUE(std::fetestexcept(FE_OVERFLOW));
  std::feclearexcept(FE_ALL_EXCEPT);
}

}  // namespace
}  // namespace axiscert
