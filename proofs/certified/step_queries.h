// Queries at which the answer of a recorded step depends on the last bit of what it compares.
#pragma once

#include <random>

#include "proofs/certified/recorded_answers.h"
#include "proofs/certified/turns.h"

namespace axiscert::proofs::certified {

// Random queries of sizes at which a range of some step ends, queries of few bits with margins of zero or nearly so,
// some of any bits; and pairs of queries an ulp apart between which an answer changes, one coordinate after the other.
template <class Real>
class StepQueries {
 public:
  explicit StepQueries(std::uint64_t seed) : random_(seed) {}

  // About `count` of them.
  QueryBatch<Real> of(RecordedAnswers<Real>& step, std::size_t count) {
    QueryBatch<Real> all(count, coordinate_count);
    for (std::size_t i = 0; i < count / 8; ++i) {
      all.push_back(i % 4 == 0 ? any_bits() : scaled(ordinary(), end_of_a_range()));
      all.push_back(near_zero());
    }
    for (std::size_t i = 0; all.size() + 2 < count; ++i) {
      const int exponent = end_of_a_range(), other = static_cast<int>(random_() % 5) - 2;
      const Query<Real> q = i % 4 == 0 ? near_zero() : scaled(ordinary(), exponent);
      const std::size_t coordinate = i % coordinate_count;
      append_turn(q, coordinate, coordinates(scaled(ordinary(), exponent + other))[coordinate], step, all);
    }
    return all;
  }

 private:
  Query<Real> any_bits() {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = std::bit_cast<Real>(static_cast<BitsOf<Real>>(random_()));
    return from_coordinates(v);
  }
  // In [-1, 1), some with a negative radius, a repeated vertex or a centre that shares coordinates with each vertex.
  Query<Real> ordinary() {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = std::ldexp(static_cast<Real>(static_cast<std::int64_t>(random_()) >> 11), -52);
    if (random_() % 8 != 0) v[12] = std::fabs(v[12]);
    Query<Real> q = from_coordinates(v);
    if (random_() % 4 == 0) q.b = q.a;
    if (random_() % 4 == 0) q.p = {q.a.x, q.b.y, q.c.z};
    return q;
  }
  // Integers from -3 to 3, with repeated vertices and centres on vertices among them; half of them with one number a
  // little off.
  Query<Real> near_zero() {
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = static_cast<Real>(static_cast<int>(random_() % 7) - 3);
    v[12] = std::fabs(v[12]);
    if (random_() % 3 == 0) std::copy_n(v.begin(), 3, v.begin() + 3);
    if (random_() % 5 == 0) std::copy_n(v.begin() + 3, 3, v.begin() + 6);
    if (random_() % 7 == 0) std::copy_n(v.begin(), 3, v.begin() + 9);
    if (random_() % 2 == 0) {
      v[random_() % 13] += std::ldexp(Real{1}, -static_cast<int>(random_() % (sizeof(Real) == 4 ? 30 : 120)));
    }
    return from_coordinates(v);
  }
  int end_of_a_range() {
    constexpr int ends32[] = {0, 0, 0, 0, -10, -11, 18, -20, 29, -119, 124};
    constexpr int ends64[] = {0, 0, 0, 0, -150, 149, -100, 99, -50, -51, -200, 199, -995, 1019};
    if constexpr (sizeof(Real) == 4) return ends32[random_() % std::size(ends32)];
    else return ends64[random_() % std::size(ends64)];
  }
  static Query<Real> scaled(const Query<Real>& q, int exponent) {
    auto v = coordinates(q);
    for (Real& x : v) x = std::ldexp(x, exponent);
    return from_coordinates(v);
  }

  std::mt19937_64 random_;
};

}  // namespace axiscert::proofs::certified
