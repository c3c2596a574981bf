// For the tests of boxes: queries at random, verdicts of formulae, and counts of wrong ones.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>

#include "exact/boxes/measures.h"
#include "exact/boxes/clipping.h"
#include "exact/judge/trait.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {

using Random = std::mt19937_64;

inline int below(Random& random, int bound) { return static_cast<int>(random() % static_cast<unsigned>(bound)); }
inline double whole(Random& random, int bound) { return below(random, 2 * bound + 1) - bound; }
inline Vec3<double> whole_vector(Random& random, int bound) {
  const double x = whole(random, bound), y = whole(random, bound), z = whole(random, bound);
  return {x, y, z};
}
// In [low, high), a multiple of 2^-20 of the range.
inline double real(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 44) * 0x1p-20;
}

// Small integers: axes up to `axis` in magnitude, half extents from 0 to 2, centres up to `centre`.
inline OrientedBox<double> small_box(Random& random, int axis, int centre) {
  OrientedBox<double> box;
  box.centre = whole_vector(random, centre);
  for (double& s : box.half) s = below(random, 3);
  for (Vec3<double>& v : box.axis) v = whole_vector(random, axis);
  return box;
}
inline double volume(const OrientedBox<double>& box) { return dot(box.axis[0], facet_normal(box, 0)); }

inline OrientedBox<double> independent_box(Random& random, int axis, int centre) {
  for (;;) {
    const OrientedBox<double> box = small_box(random, axis, centre);
    if (volume(box) != 0) return box;
  }
}
inline BoxPair<double> independent_pair(Random& random, int axis = 2, int centre = 6) {
  const OrientedBox<double> a = independent_box(random, axis, centre);
  return {a, independent_box(random, axis, centre)};
}

// The edges half_k axis_k as the axes, each with half extent 1: the same body.
inline OrientedBox<double> by_half_edges(OrientedBox<double> box) {
  for (std::size_t k = 0; k < 3; ++k) box.axis[k] = box.axis[k] * box.half[k];
  box.half = {1, 1, 1};
  return box;
}

// Whether one of the comparisons of F holds, in number type T.
template <class F, class T = double, class Problem>
bool separates(const Problem& problem) {
  bool any = false;
  const auto sink = [&](std::size_t, const T& lhs, const T& rhs) { any = any || lhs > rhs; };
  F::template comparisons<T>(problem, sink);
  return any;
}

// A query in exact numbers.
template <class Test, class Real>
auto exact_problem(const Numbers<Real>& numbers) {
  return Test::template problem<ExactNumber>(
      [&](std::size_t k) { return ExactNumber(static_cast<double>(numbers[k])); });
}

inline bool are_apart(const ExactPair& q) { return squared_distance(q) > 0; }
inline bool are_apart(const BoxPair<double>& q) { return are_apart(exact_pair(q)); }

// Wrong verdicts among queries.
struct Wrong {
  int asked = 0, missed = 0, phantom = 0;
  double deepest_miss = 0;  // relative to the scene

  void count(bool said_apart, bool is_apart) {
    ++asked;
    missed += said_apart && !is_apart;
    phantom += !said_apart && is_apart;
  }
  int all() const { return missed + phantom; }
};
inline std::ostream& operator<<(std::ostream& out, const Wrong& wrong) {
  return out << wrong.missed << " missed, " << wrong.phantom << " phantom of " << wrong.asked;
}

// Whether a count among `asked` is within a factor of 1.5 of the rate `published` of `of`. Where fewer are asked than
// the test names, counts vary more: within 3, and 5 more.
inline void expect_about(int count, int asked, double published, double of) {
  const double expected = published * asked / of;
  const double factor = TRIAL_DIVISOR == 1 ? 1.5 : 3, more = TRIAL_DIVISOR == 1 ? 0 : 5;
  EXPECT_GE(count, expected / factor - more) << "expected about " << expected;
  EXPECT_LE(count, expected * factor + more) << "expected about " << expected;
}

}  // namespace axiscert::boxes
