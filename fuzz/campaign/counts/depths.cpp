#include "fuzz/campaign/counts/depths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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
  return size == 0 ||
         (size >= std::numeric_limits<Real>::min() && size <= static_cast<Real>(greatest_engine_coordinate));
}
template <class Real>
bool is_engine_radius(Real r) {
  return r >= static_cast<Real>(least_engine_radius) && r <= static_cast<Real>(greatest_engine_radius);
}

}  // namespace

std::size_t decade_of(double depth) {
  if (depth == 0) return 0;
  return 1 + static_cast<std::size_t>(std::upper_bound(std::begin(powers_of_ten), std::end(powers_of_ten), depth) -
                                      std::begin(powers_of_ten));
}

std::size_t decade_of(DepthOf& depth) {
  const std::size_t low = decade_of(depth.at_least());
  return low == decade_of(depth.at_most()) ? low : decade_of(depth.exactly());
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
  constexpr std::size_t radius = coordinate_count - 1;
  std::vector<unsigned char> is_one(columns.size);
  for (std::size_t i = 0; i < columns.size; ++i) is_one[i] = is_engine_radius(columns.column[radius][i]);
  for (std::size_t c = 0; c < radius; ++c) {
    for (std::size_t i = 0; i < columns.size; ++i) is_one[i] &= is_engine_coordinate(columns.column[c][i]);
  }
  return static_cast<std::uint64_t>(std::count(is_one.begin(), is_one.end(), 1));
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
