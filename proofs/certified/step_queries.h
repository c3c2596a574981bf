// Queries at which the answer of a recorded step depends on the last bit of what it compares.
#pragma once

#include <limits>
#include <random>

#include "proofs/certified/evaluate.h"
#include "proofs/certified/turns.h"

namespace axiscert::proofs::certified {

// Random queries of sizes at which a range of some step ends, queries of few bits with margins of zero or nearly so,
// some of any bits or with numbers that are not finite; queries whose terms cancel but for what rounding hides
// (close()); and pairs of queries an ulp apart between which an answer changes, one coordinate after the other.
template <class Real>
class StepQueries {
 public:
  explicit StepQueries(std::uint64_t seed) : random_(seed) {}

  // About `count` of them.
  QueryBatch<Real> of(RecordedAnswers<Real>& step, std::size_t count) {
    QueryBatch<Real> all(count, coordinate_count);
    all.push_back(Query<Real>{});  // a point in a point
    for (std::size_t i = 0; i < count / 8; ++i) {
      all.push_back(i % 4 == 0 ? any_bits() : scaled(ordinary(), end_of_a_range()));
      all.push_back(i % 2 == 0 ? near_zero() : special(i / 2));
    }
    for (std::size_t i = 0; i < count / 4; ++i) all.push_back(close(i));
    for (std::size_t i = 0; all.size() + 2 < count; ++i) add_turns(i, step, all);
    return all;
  }

 private:
  void add_turns(std::size_t i, RecordedAnswers<Real>& step, QueryBatch<Real>& all) {
    const int exponent = end_of_a_range();
    const bool is_one_of_its_own_size = i % 8 == 1, is_centred = i % 4 == 3;
    const int other = is_one_of_its_own_size ? end_of_a_range() : exponent + static_cast<int>(random_() % 5) - 2;
    Query<Real> q = i % 4 == 0   ? near_zero()
                    : i % 8 == 2 ? nearly_repeated()
                    : i % 8 == 6 ? flat()
                                 : scaled(ordinary(), exponent);
    if (is_centred) q.p = {Real{0}, Real{0}, Real{0}};
    const std::size_t before = all.size(), coordinate = (i / 8) % coordinate_count;
    append_turn(q, coordinate, coordinates(scaled(ordinary(), other))[coordinate], step, all);
    if (!is_centred || all.size() == before) return;
    // From there a centre of less than an ulp, where pairs of numbers decide.
    constexpr int places = std::numeric_limits<Real>::digits;
    const Real to = std::ldexp(static_cast<Real>(whole(4)), exponent - places);
    const Query<Real> at_turn = all[before];
    append_turn(at_turn, 9 + random_() % 3, to, step, all);
  }
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
  // Margins far smaller than their terms, for the steps that tell their signs by residues.
  Query<Real> close(std::size_t i) {
    switch (i % 8) {
      case 0:
        return low_parts();
      case 1:
        return orthogonal();
      case 2:
        return parallel();
      case 3:
      case 4:
        return speck();
      default:
        return two_sizes();
    }
  }
  int whole(int limit) { return static_cast<int>(random_() % (2 * limit + 1)) - limit; }
  // How far apart two numbers are; often so far that an error of 2^-102 of the greater's square, fourth or sixth power
  // is about 2^60 of the less's.
  int places_apart() {
    constexpr int limits[] = {56, 39, 26};
    return random_() % 2 == 0 ? limits[random_() % 3] + whole(4)
                              : static_cast<int>(random_() % (2 * std::numeric_limits<Real>::digits));
  }
  // Numbers that are not finite, or too great for squares, beside ordinary ones.
  Query<Real> special(std::size_t i) {
    constexpr Real huge = std::numeric_limits<Real>::max();
    constexpr Real values[] = {std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(), huge,
                               huge / 4};
    auto v = coordinates(i % 2 == 0 ? ordinary() : near_zero());
    v[random_() % coordinate_count] = values[random_() % std::size(values)];
    return from_coordinates(v);
  }
  // Small integers in two units, one up to a hundred binary places above the other or so far that its products with the
  // other underflow: what is left where the terms of the greater unit cancel is smaller than any rounding of theirs.
  Query<Real> two_sizes() {
    const int greater = static_cast<int>(random_() % (2 * std::numeric_limits<Real>::digits)),
              less = greater - places_apart();
    std::array<Real, coordinate_count> v;
    const bool is_centred = random_() % 2 == 0;
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      const Real great = std::ldexp(static_cast<Real>(whole(2)), greater),
                 small = std::ldexp(static_cast<Real>(whole(3)), less);
      const auto kind = random_() % 8;
      v[k] = kind < 3 ? great : kind < 6 ? small : kind == 6 ? great + small : Real{0};
      if (is_centred && k >= 9 && k < 12) v[k] = Real{0};
    }
    v[12] = std::fabs(random_() % 2 == 0 ? v[random_() % 9] : v[12]);
    const auto same = random_() % 8;
    if (same == 0) std::copy_n(v.begin(), 3, v.begin() + 3);
    if (same == 1) std::copy_n(v.begin() + 3, 3, v.begin() + 6);
    if (same == 2) std::copy_n(v.begin(), 3, v.begin() + 6);
    return from_coordinates(v);
  }
  // A vertex (X - 1, y, 0) from the centre and a radius of X, where 2 X is y^2 + 1 but for a few units: X - 1 needs
  // more than a number, and the squares cancel all but these units.
  Query<Real> low_parts() {
    constexpr int half = std::numeric_limits<Real>::digits / 2 + 4;
    auto v = coordinates(two_sizes());
    const std::int64_t y = (std::int64_t{1} << half) + whole(99);
    const std::int64_t X = (y * y + 1 + 64) / 2 / 64 * 64 + 64 * whole(1) * static_cast<int>(random_() % 2);
    const std::size_t x = random_() % 3, vertex = 3 * (random_() % 3), other = (x + 1 + random_() % 2) % 3;
    for (std::size_t k = 0; k < 3; ++k) v[vertex + k] = v[9 + k] = 0;
    v[vertex + x] = v[12] = static_cast<Real>(X);
    v[9 + x] = 1;
    v[vertex + other] = static_cast<Real>(y);
    return scaled(from_coordinates(v), whole(60) / (sizeof(Real) == 4 ? 4 : 1));
  }
  // Edges from A that are perpendicular to it but for a few units, which the products of its greatest components hide.
  Query<Real> orthogonal() {
    constexpr int places = std::numeric_limits<Real>::digits;
    const Real X = std::ldexp(Real{1}, places - 5 + static_cast<int>(random_() % 5));
    const auto small = [&] { return static_cast<Real>(whole(3)); };
    const Real along[3][3] = {{X, small(), 0}, {X, small(), X}, {X, small(), random_() % 2 == 0 ? X : -X}};
    std::array<Real, coordinate_count> v{};
    const std::size_t turn = random_() % 3;
    for (std::size_t k = 0; k < 9; ++k) v[k / 3 * 3 + (k + turn) % 3] = along[k / 3][k % 3];
    v[12] = random_() % 2 == 0 ? X : small();
    return scaled(from_coordinates(v), whole(40) / (sizeof(Real) == 4 ? 4 : 1));
  }
  // Neighbours (n + 1, n) and (n, n - 1) in a plane of coordinates: their product has one component that is not zero,
  // -1.
  Query<Real> parallel() {
    const auto n = std::ldexp(Real{1}, std::numeric_limits<Real>::digits - 2) - static_cast<Real>(random_() % 99);
    const Real d = static_cast<Real>(random_() % 2);
    std::array<Real, coordinate_count> v{};
    const std::size_t x = random_() % 3, y = (x + 1) % 3;
    const auto put = [&](std::size_t vertex, Real a, Real b) {
      v[3 * vertex + x] = a;
      v[3 * vertex + y] = b;
    };
    if (random_() % 2 == 0) {  // A and AB
      put(0, n + d, n);
      put(1, n + d + n, n + (n - d));
      for (std::size_t k = 6; k < 9; ++k) v[k] = static_cast<Real>(whole(2)) * (random_() % 2 == 0 ? n : 1);
    } else {  // AB and AC
      put(1, n + d, n);
      put(2, n, n - d);
      for (std::size_t k = 9; k < 12; ++k) v[k] = random_() % 2 == 0 ? static_cast<Real>(whole(1)) * n : Real{0};
    }
    v[12] = random_() % 2 == 0 ? Real{0} : random_() % 2 == 0 ? n : Real{1};
    return scaled(from_coordinates(v), whole(40) / (sizeof(Real) == 4 ? 4 : 1));
  }
  // Vertices a few ulps from others, of a size at which an edge leaves the range of edges.
  Query<Real> nearly_repeated() {
    const Query<Real> q =
        scaled(ordinary(), random_() % 2 == 0 ? end_of_a_range() : -49 + static_cast<int>(random_() % 4));
    auto v = coordinates(q);
    const std::size_t from = 3 * (random_() % 3), to = 3 * (random_() % 3);
    for (std::size_t k = 0; k < 3; ++k) v[to + k] = at_place<Real>(place(v[from + k]) + whole(2));
    for (std::size_t k = 9; k < 12; ++k) v[k] = 0;
    return from_coordinates(v);
  }
  // Zeros and ones in a great unit, but for one number so small that its product with a unit of the step's underflows.
  Query<Real> speck() {
    const Real unit =
        std::ldexp(Real{1}, 2 * std::numeric_limits<Real>::digits - 10 - static_cast<int>(random_() % 30));
    std::array<Real, coordinate_count> v;
    for (Real& x : v) x = static_cast<Real>(whole(1)) * unit;
    v[12] = std::fabs(v[12]);
    v[random_() % coordinate_count] = at_place<Real>(1 + static_cast<std::int64_t>(random_() % 9));
    return from_coordinates(v);
  }
  // A triangle of small height whose plane is the one axis that separates, if any; or one whose height is rounding
  // alone.
  Query<Real> flat() {
    if (random_() % 2 == 0) {
      auto v = coordinates(ordinary());
      const Real at = v[12];
      for (std::size_t k = 0; k < 3; ++k) v[6 + k] = v[k] + at * (v[3 + k] - v[k]), v[9 + k] = 0;
      v[12] = std::ldexp(v[12], -static_cast<int>(random_() % 30));
      return from_coordinates(v);
    }
    const Real height = std::ldexp(Real{1}, -static_cast<int>(random_() % (sizeof(Real) == 4 ? 45 : 90)));
    const Real radius = Real{1} - static_cast<Real>(random_() % 300) * std::numeric_limits<Real>::epsilon() / 2;
    std::array<Real, coordinate_count> v = {-1, 0, 1, 1, 0, 1, 0, height, 1, 0, 0, 0, radius};
    return from_coordinates(v);
  }
  int end_of_a_range() {
    constexpr int ends32[] = {0, 0, 0, 0, -10, -11, 18, -20, 29, -119, 124};
    constexpr int ends64[] = {0, 0, 0, -150, -150, -151, 149, -100, 99, -50, -51, -200, 199, -995, 1019};
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
