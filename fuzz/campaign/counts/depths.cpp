#include "fuzz/campaign/counts/depths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace axiscert {
namespace {

// The nearest binary64 of each: a compiler rounds a literal so.
constexpr double powers_of_ten[] = {1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10,
                                    1e-9,  1e-8,  1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0};
static_assert(std::size(powers_of_ten) == decade_count - 2);

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

std::size_t decade_of(double depth) {
  if (depth == 0) return 0;
  return 1 + static_cast<std::size_t>(std::upper_bound(std::begin(powers_of_ten), std::end(powers_of_ten), depth) -
                                      std::begin(powers_of_ten));
}

std::size_t decade_of(DepthOf& depth) {
  if (depth.is_touching()) return 0;
  const auto above_zero = [](double x) { return std::max(decade_of(x), std::size_t{1}); };
  const std::size_t low = above_zero(depth.at_least());
  return low == above_zero(depth.at_most()) ? low : above_zero(depth.exactly());
}

std::string decade_name(std::size_t decade) {
  if (decade == 0) return "zero";
  if (decade == 1) return "less";
  return std::to_string(static_cast<int>(decade) - 2 + least_decade);
}

void DepthTally::merge(const DepthTally& other) {
  for (std::size_t i = 0; i < decade_count; ++i) {
    false_separation[i] += other.false_separation[i];
    false_contact[i] += other.false_contact[i];
  }
}

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

void count_depth(DepthTally& depths, EngineTally& engine, FlipKind kind, DepthOf& depth) {
  const std::size_t decade = decade_of(depth);
  ++depths.of(kind)[decade];
  const double threshold = depth.engine_threshold();
  if (depth.at_most() <= threshold) return;
  if (depth.at_least() > threshold || depth.exactly() > threshold) ++engine.wrong.of(kind)[decade];
}

}  // namespace axiscert
