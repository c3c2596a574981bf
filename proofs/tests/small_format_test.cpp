// Every query of a reduced space, in formats of a few bits: the computed sides are compared with the exact ones and
// with the error bound of the format, and none of the three answers of a filter made from the bound is certain and
// wrong.
//
// P is the origin, so that nothing is translated; every coordinate is a number of the format in [-1, 1], and r one in
// [0, 1]. Symmetry: negating one coordinate of A, B and C negates both factors of every product of that coordinate, or
// one factor in each term of a cross product's component. Sums keep their order, and rounding to nearest is odd, so
// every side keeps its bits: A's coordinates are taken >= 0.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <vector>

#include "proofs/program.h"
#include "proofs/tests/small_float.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/reduced.h"

namespace axiscert::proofs {
namespace {

struct Count {
  std::uint64_t queries = 0, inexact = 0, flips = 0, certain = 0;
  double most = 0;  // the greatest ratio of an error to its bound
};

// The numbers of the format in [0, 1], with their negatives if `negative`.
std::vector<double> numbers(int digits, int least_exponent, bool negative) {
  std::vector<double> all;
  const double last = std::ldexp(1.0, least_exponent);
  for (double x = 0; x <= 1; x += last) {
    const double place = x == 0 ? last : std::max(last, std::ldexp(1.0, std::ilogb(x) - (digits - 1)));
    if (std::fmod(x, place) != 0) continue;
    if (negative && x > 0) all.push_back(-x);
    all.push_back(x);
  }
  return all;
}

template <class F, int Digits, int LeastExponent>
void compare(const Query<double>& query, const std::array<double, comparison_count>& bounds, Count& count) {
  using Number = SmallFloat<Digits, LeastExponent>;
  // Coordinates and radii are multiples of 2^LeastExponent, and sides are of degree six at most and below 2^10:
  // binary64 is exact.
  static_assert(-6 * LeastExponent + 10 <= 53);
  const auto exact = sides_of<F>(problem_as<double>(query, [](double x) { return x; }));
  const auto computed = sides_of<F>(problem_as<Number>(query, [](double x) { return Number(x); }));
  ++count.queries;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const double margin = exact.lhs[k] - exact.rhs[k], found = computed.lhs[k].value() - computed.rhs[k].value();
    const double error = std::fabs(found - margin);
    count.inexact += error != 0;
    count.flips += (found > 0) != (margin > 0);
    count.most = std::max(count.most, error / bounds[k]);
    ASSERT_LE(error, bounds[k]) << comparisons[k].name;
    // The filter's certain answers.
    count.certain += std::fabs(found) > bounds[k];
    ASSERT_FALSE(found > bounds[k] && margin <= 0) << comparisons[k].name;
    ASSERT_FALSE(found < -bounds[k] && margin >= 0) << comparisons[k].name;
  }
}

// Choices for the coordinates of A (not negative, by symmetry), for those of B and C except C's z, and for C's z; and
// for the radius.
struct Space {
  std::vector<double> a, others, last, radii;
};

template <class F, int Digits, int LeastExponent>
Count exhaust(Form form, const Space& space) {
  const auto begun = std::chrono::steady_clock::now();
  const auto bounds = forward_error(record(form, Contraction::plain), Digits, LeastExponent);
  Count count;
  Query<double> q{};
  // Nine nested loops as one counter, whose digits run from A's x to C's z.
  std::array<std::size_t, 9> at{};
  const auto choices = [&](std::size_t i) -> const std::vector<double>& {
    return i < 3 ? space.a : i < 8 ? space.others : space.last;
  };
  std::array<double, 9> v{};
  for (std::size_t i = 0; i < 9; ++i) v[i] = choices(i)[0];
  for (bool more = true; more;) {
    q.a = {v[0], v[1], v[2]};
    q.b = {v[3], v[4], v[5]};
    q.c = {v[6], v[7], v[8]};
    for (const double r : space.radii) {
      q.r = r;
      compare<F, Digits, LeastExponent>(q, bounds, count);
      if (testing::Test::HasFatalFailure()) return count;
    }
    more = false;
    for (std::size_t i = 0; i < 9 && !more; ++i) {
      more = ++at[i] < choices(i).size();
      if (!more) at[i] = 0;
      v[i] = choices(i)[at[i]];
    }
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begun;
  std::printf(
      "%.*s, %d digits, least 2^%d: %llu queries, %llu inexact margins, %llu flips, %llu certain; error at most "
      "%.3f of the bound; %.1f s\n",
      static_cast<int>(name(form).size()), name(form).data(), Digits, LeastExponent,
      static_cast<unsigned long long>(count.queries), static_cast<unsigned long long>(count.inexact),
      static_cast<unsigned long long>(count.flips), static_cast<unsigned long long>(count.certain), count.most,
      seconds.count());
  EXPECT_GT(count.flips, 0u) << "nothing went wrong: nothing was tested";
  return count;
}

// Three magnitudes of a format with four digits, with all signs; C's z is 0.
TEST(SmallFormat, NoMarginLeavesItsBound) {
  const Space space{{0, 0.6875, 0.9375}, {0, 0.6875, -0.6875, 0.9375, -0.9375}, {0}, {0.4375}};
  for (const Count& count : {exhaust<portable::PublishedFormulae, 4, -7>(Form::published, space),
                             exhaust<portable::ReducedFormulae, 4, -7>(Form::reduced, space)}) {
    EXPECT_GT(count.certain, 0u);
  }
}

// Every query of a whole format: 0, 1/4, 1/2, 1 with all signs, every radius.
TEST(SmallFormatLong, NoMarginLeavesItsBound) {
  const std::vector<double> half = numbers(1, -2, false), all = numbers(1, -2, true);
  exhaust<portable::PublishedFormulae, 1, -2>(Form::published, {half, all, all, half});
  exhaust<portable::ReducedFormulae, 1, -2>(Form::reduced, {half, all, all, half});
}

// binary32 is the format of 24 digits: its operations are the processor's.
TEST(SmallFloat, IsBinary32At24Digits) {
  using Single = SmallFloat<24, -149>;
  std::uint64_t state = 1;
  for (int i = 0; i < 100'000; ++i) {
    const auto next = [&] {
      state = state * 6364136223846793005u + 1442695040888963407u;
      return std::ldexp(static_cast<float>(static_cast<std::int32_t>(state >> 32)),
                        -20 - static_cast<int>((state >> 20) % 60));
    };
    const float a = next(), b = next();
    ASSERT_EQ((Single(a) * Single(b)).value(), static_cast<double>(a * b));
    ASSERT_EQ((Single(a) - Single(b)).value(), static_cast<double>(static_cast<float>(static_cast<double>(a) - b)));
  }
}

}  // namespace
}  // namespace axiscert::proofs
