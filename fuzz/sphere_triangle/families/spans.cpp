// Larger integers than those of `units`, of which a clear query is one for any method; times powers of two, and moved.
#include <algorithm>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/images.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/family.h"

namespace axiscert {
namespace {

template <class Real>
constexpr int span_bits = sizeof(Real) == 4 ? 10 : 24;

using Integers = Vec3<std::int64_t>;
using IntegerVertices = std::array<Integers, 3>;

constexpr std::int64_t beside = 2;
// Small, middling and large.
template <class Real>
constexpr std::array<std::int64_t, 3> span_sizes = {4, (std::int64_t{1} << span_bits<Real> / 2) - beside,
                                                    (std::int64_t{1} << span_bits<Real>)-beside};

// In turn any triangle, a needle with C beside A, and a sliver with C beside the middle of AB.
IntegerVertices integer_vertices(Stream& random, std::uint64_t turn, std::int64_t size) {
  IntegerVertices v;
  for (Integers& vertex : v) vertex = shapes::integers(random, size);
  switch (turn % 3) {
    case 1:
      v[2] = v[0] + shapes::integers(random, beside);
      break;
    case 2:
      for (std::size_t i = 0; i < 2; ++i) v[i] = shapes::integers(random, size / 2);
      v[2] = v[0] + v[1] + shapes::integers(random, beside);
      for (std::size_t i = 0; i < 2; ++i) v[i] = v[i] + v[i];
      break;
    default:
      break;
  }
  return v;
}

template <class Real>
Query<Real> rounded_query(Stream& random, const IntegerVertices& v, const Integers& p, std::int64_t greatest_radius) {
  const auto rounded = [](const Integers& point) {
    return Vec3<Real>{static_cast<Real>(point.x), static_cast<Real>(point.y), static_cast<Real>(point.z)};
  };
  const auto vertices = shapes::shuffled<Real>(random, {rounded(v[0]), rounded(v[1]), rounded(v[2])});
  return shapes::query(vertices, rounded(p), static_cast<Real>(random.integer(0, 2 * greatest_radius)) / 2);
}

// Anywhere in every other base; in the others the centre is beside a point of the face, a vertex or an edge in turn,
// with a radius that reaches that feature or falls short, but seldom reaches another.
template <class Real>
Query<Real> integer_query(Stream& random, std::uint64_t base) {
  const auto& sizes = span_sizes<Real>;
  const std::uint64_t turn = base / 2;
  const std::int64_t size = sizes[turn % 3];
  if (base % 2 == 0) {
    const std::int64_t distance = sizes[turn / 3 % 3];
    const IntegerVertices v = integer_vertices(random, turn / 9, size);
    const Integers p = shapes::integers(random, distance);
    return rounded_query<Real>(random, v, p, random.coin() ? 4 : 2 * std::max(size, distance));
  }
  // Vertices that are four times integers have points in integers on each feature. They stay below three quarters of
  // the size, and the centre below the size.
  const auto w = shapes::weights(random, static_cast<Axis>(turn / 9 % axis_count), 4);
  IntegerVertices v = integer_vertices(random, turn / 3, std::max<std::int64_t>(size * 3 / 16, 2));
  const std::int64_t reach = std::max<std::int64_t>(size / 16, 1);
  Integers p = shapes::integers(random, reach);
  for (std::size_t i = 0; i < 3; ++i) {
    p = p + v[i] * w[i];
    v[i] = v[i] * std::int64_t{4};
  }
  return rounded_query<Real>(random, v, p, 2 * reach);
}

template <class Real>
constexpr PowerRange spans_range = range_of_degree_6<Real>(std::int64_t{1} << span_bits<Real>);
PowerRange spans_range_in(Precision precision) {
  return precision == Precision::binary32 ? spans_range<float> : spans_range<double>;
}

// Four translations after the powers of two, by at most 2^k in each coordinate: k in turn from 0 to the greatest with
// which every coordinate is still an integer of the precision.
constexpr std::size_t translations = 4, group_size = unit_images::count + translations;

template <class Real>
Query<Real> moved_span(Stream& random, const Query<Real>& q, std::uint64_t base, std::size_t which) {
  constexpr std::uint64_t sizes = std::numeric_limits<Real>::digits - 1;
  const std::int64_t most = std::int64_t{1} << (base * translations + which) % sizes;
  const Vec3<std::int64_t> by = shapes::integers(random, most);
  const Vec3<Real> offset = {static_cast<Real>(by.x), static_cast<Real>(by.y), static_cast<Real>(by.z)};
  return {q.a + offset, q.b + offset, q.c + offset, q.p + offset, q.r};
}

template <class Real>
void fill_spans(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  fill_groups(name, first, out, group_size, integer_query<Real>,
              [](Stream& random, const Query<Real>& q, std::uint64_t base, std::size_t i) {
                if (i >= unit_images::count) return moved_span(random, q, base, i - unit_images::count);
                return times_power(q, unit_images::exponent(spans_range<Real>, base, i));
              });
}

}  // namespace

extern const ImageGroup spans_group = {
    sphere_triangle_predicate,
    "spans",
    group_size,
    [](std::size_t) {
      return std::array<std::uint8_t, 3>{0, 1, 2};
    },
    [](std::size_t i) { return i < unit_images::count ? ImageKind::scale : ImageKind::translation; },
    [](Precision precision, std::uint64_t base, std::size_t i) {
      return unit_images::exponent(spans_range_in(precision), base, i);
    },
    spans_range_in};

extern const Family spans_family = {
    sphere_triangle_predicate,
    "spans",
    "integers below 2^10 or 2^24, times seven powers of two in the range of degree 6, and moved four times, exactly",
    1,
    false,
    fill_spans<float>,
    fill_spans<double>};

}  // namespace axiscert
