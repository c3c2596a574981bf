#include "exact/sphere_triangle/measures/engine_like.h"

#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace axiscert {
namespace {

constexpr double greatest_engine_coordinate = 0x1p20, least_engine_radius = 0x1p-20, greatest_engine_radius = 0x1p20;

template <class Real>
bool is_engine_coordinate(Real x) {
  const Real size = std::abs(x);
  const bool is_within =
      (size >= std::numeric_limits<Real>::min()) & (size <= static_cast<Real>(greatest_engine_coordinate));
  return (size == 0) | is_within;
}
template <class Real>
bool is_engine_radius(Real r) {
  return (r >= static_cast<Real>(least_engine_radius)) & (r <= static_cast<Real>(greatest_engine_radius));
}

}  // namespace

template <class Real>
bool is_engine_like(const Query<Real>& q) {
  for (const Vec3<Real>& point : {q.a, q.b, q.c, q.p}) {
    for (const Real x : {point.x, point.y, point.z}) {
      if (!is_engine_coordinate(x)) return false;
    }
  }
  return is_engine_radius(q.r);
}
template bool is_engine_like(const Query<float>&);
template bool is_engine_like(const Query<double>&);

template <class Real>
std::uint64_t engine_like_queries(const QueryColumns<Real>& columns) {
  // Blocks of a fixed size and flags as wide as a number: a compiler makes vectors of these loops.
  constexpr std::size_t radius = coordinate_count - 1, block = 64;
  using Flag = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  const auto count_from = [&](std::size_t first, auto size) {
    std::array<Flag, block> flags;
    const Real* radii = columns.column[radius] + first;
    for (std::size_t i = 0; i < size; ++i) flags[i] = is_engine_radius(radii[i]);
    for (std::size_t c = 0; c < radius; ++c) {
      const Real* x = columns.column[c] + first;
      for (std::size_t i = 0; i < size; ++i) flags[i] &= Flag{is_engine_coordinate(x[i])};
    }
    Flag count = 0;
    for (std::size_t i = 0; i < size; ++i) count += flags[i];
    return static_cast<std::uint64_t>(count);
  };
  std::uint64_t count = 0;
  std::size_t first = 0;
  for (; first + block <= columns.size; first += block) {
    count += count_from(first, std::integral_constant<std::size_t, block>());
  }
  return count + count_from(first, columns.size - first);
}
template std::uint64_t engine_like_queries(const QueryColumns<float>&);
template std::uint64_t engine_like_queries(const QueryColumns<double>&);

}  // namespace axiscert
