// Queries an ulp apart between which an answer changes.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <type_traits>

#include "kernel/sphere_triangle/query.h"

namespace axiscert::proofs {

template <class Real>
using BitsOf = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

// The position of a number among the numbers of the format, so that the way from one number to another can be halved.
template <class Real>
std::int64_t place(Real x) {
  const auto bits = static_cast<std::int64_t>(std::bit_cast<BitsOf<Real>>(std::fabs(x)));
  return std::signbit(x) ? -bits : bits;
}
template <class Real>
Real at_place(std::int64_t i) {
  const Real size = std::bit_cast<Real>(static_cast<BitsOf<Real>>(std::abs(i)));
  return i < 0 ? -size : size;
}

// Appends the queries, an ulp apart, between which the answer changes as one coordinate goes from its value in q to
// `to`. There the answer depends on the last bit of the values that are compared.
template <class Real, class Answer>
void append_turn(const Query<Real>& q, std::size_t coordinate, Real to, Answer&& answer, QueryBatch<Real>& found) {
  auto v = coordinates(q);
  const auto with = [&](std::int64_t i) {
    v[coordinate] = at_place<Real>(i);
    return from_coordinates(v);
  };
  std::int64_t one = place(v[coordinate]), other = place(to);
  const auto first = answer(with(one));
  if (answer(with(other)) == first) return;
  // Rounded towards `one`; the way from the least number to the greatest is longer than an int64_t.
  for (std::int64_t middle; (middle = std::midpoint(one, other)) != one;)
    (answer(with(middle)) == first ? one : other) = middle;
  found.push_back(with(one));
  found.push_back(with(other));
}

}  // namespace axiscert::proofs
