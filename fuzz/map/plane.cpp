#include "fuzz/map/plane.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "fuzz/search/moves.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::uint16_t every_place = (1u << coordinate_count) - 1, vertex_places = (1u << 9) - 1;

bool moves(const PlaneSide& side, std::size_t place) { return has_bit(side.numbers.places, place); }

void require_different(const MovedNumbers& along, const MovedNumbers& across) {
  if (along.places != across.places) return;
  throw Error(fmt::format("--along {0} --across {0}: the two sides of a map move different numbers", along.name));
}

// The greatest exponent of the moved numbers.
template <class Real>
int exponent_of(const Query<Real>& witness, const MovedNumbers& numbers) {
  Real greatest = 0;
  const auto v = coordinates(witness);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    if (has_bit(numbers.places, k)) greatest = std::max(greatest, std::fabs(v[k]));
  }
  if (greatest == 0) throw Error(fmt::format("{}: zero in this query, and so zero at every exponent", numbers.name));
  return std::ilogb(greatest);
}

template <class Real>
PlaneSide exponent_side(const Query<Real>& witness, const MovedNumbers& numbers, std::size_t size) {
  using Limits = std::numeric_limits<Real>;
  const int now = exponent_of(witness, numbers);
  const std::int64_t least = Limits::min_exponent - Limits::digits - now, greatest = Limits::max_exponent - 1 - now;
  const auto all = static_cast<std::size_t>(greatest - least + 1);
  const auto step = static_cast<std::int64_t>((all + size - 1) / size);
  const std::int64_t below = -least / step, above = greatest / step;
  return {numbers, -below * step, step, static_cast<std::size_t>(below + above + 1)};
}

}  // namespace

MovedNumbers parse_numbers(std::string_view name) {
  constexpr std::string_view points = "abcp", xyz = "xyz";
  const std::string text(name);
  if (name == "r") return {text, one_bit<std::uint16_t>(12)};
  if (name == "scene") return {text, every_place};
  if (name == "triangle") return {text, vertex_places};
  const std::size_t point = name.empty() ? points.npos : points.find(name[0]);
  if (point != points.npos && name.size() == 1) return {text, static_cast<std::uint16_t>(7u << (3 * point))};
  const std::size_t axis = name.size() == 3 && name[1] == '.' ? xyz.find(name[2]) : xyz.npos;
  if (point != points.npos && axis != xyz.npos) return {text, one_bit<std::uint16_t>(3 * point + axis)};
  std::string guess;  // "ax" and "a.X" are near
  for (const char p : points) {
    for (const char x : xyz) {
      if (name.size() >= 2 && name.front() == p && (name.back() | 0x20) == x) guess = fmt::format("{}.{}", p, x);
    }
  }
  throw Error(
      fmt::format("'{}' is not a name of numbers of a query{} the names are a.x, a.y, a.z, b.x ... p.z, r and, with "
                  "--exponents, a, "
                  "b, c, p, triangle, scene",
                  name, guess.empty() ? ";" : fmt::format("; did you mean '{}'?", guess)));
}

Plane ulp_plane(const MovedNumbers& along, const MovedNumbers& across, std::size_t size, std::int64_t ulps) {
  for (const MovedNumbers& numbers : {along, across}) {
    if (std::has_single_bit(numbers.places)) continue;
    throw Error(fmt::format("{}: ulps move one number, such as a.x or r; with --exponents several move together",
                            numbers.name));
  }
  require_different(along, across);
  const std::int64_t first = -static_cast<std::int64_t>(size / 2) * ulps;
  return {PlaneKind::ulps, {along, first, ulps, size}, {across, first, ulps, size}};
}

template <class Real>
Plane exponent_plane(const Query<Real>& witness, const MovedNumbers& along, const MovedNumbers& across,
                     std::size_t size) {
  require_different(along, across);
  return {PlaneKind::exponents, exponent_side(witness, along, size), exponent_side(witness, across, size)};
}

template <class Real>
Query<Real> query_at(const Plane& plane, const Query<Real>& witness, std::size_t column, std::size_t row) {
  const std::int64_t along = plane.along.offset(column), across = plane.offset_of_row(row);
  auto v = coordinates(witness);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    const std::int64_t offset = (moves(plane.along, k) ? along : 0) + (moves(plane.across, k) ? across : 0);
    if (offset == 0) continue;  // keeps the sign of a witness's -0
    v[k] = plane.kind == PlaneKind::ulps ? moved_by_ulps(v[k], offset) : std::ldexp(v[k], static_cast<int>(offset));
  }
  return from_coordinates(v);
}

#define AXISCERT_INSTANTIATE(Real)                                                                          \
  template Plane exponent_plane(const Query<Real>&, const MovedNumbers&, const MovedNumbers&, std::size_t); \
  template Query<Real> query_at(const Plane&, const Query<Real>&, std::size_t, std::size_t);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
