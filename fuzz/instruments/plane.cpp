#include "fuzz/instruments/plane.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "fuzz/search/moves.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::string_view xyz = "xyz";

// The columns of a group.
std::uint64_t places_of(const ColumnGroup& group) {
  std::uint64_t places = 0;
  for (std::size_t k = 0; k < group.size; ++k) places |= one_bit<std::uint64_t>(group.first + k);
  return places;
}

bool is_moved(const PlaneSide& side, std::size_t place) { return has_bit(side.numbers.places, place); }

void require_different(const MovedNumbers& along, const MovedNumbers& across) {
  if (along.places != across.places) return;
  throw Error(fmt::format("--along {0} --across {0}: the two sides of a map move different numbers", along.name));
}

// The greatest exponent of the moved numbers.
template <class Real>
int exponent_of(const Numbers<Real>& witness, const MovedNumbers& numbers) {
  Real greatest = 0;
  for (std::size_t k = 0; k < witness.size(); ++k) {
    if (has_bit(numbers.places, k)) greatest = std::max(greatest, std::fabs(witness[k]));
  }
  if (greatest == 0) throw Error(fmt::format("{}: zero in this query, and so zero at every exponent", numbers.name));
  return std::ilogb(greatest);
}

template <class Real>
PlaneSide exponent_side(const Numbers<Real>& witness, const MovedNumbers& numbers, std::size_t size) {
  using Limits = std::numeric_limits<Real>;
  const int now = exponent_of(witness, numbers);
  const std::int64_t least = Limits::min_exponent - Limits::digits - now, greatest = Limits::max_exponent - 1 - now;
  const auto all = static_cast<std::size_t>(greatest - least + 1);
  const auto step = static_cast<std::int64_t>((all + size - 1) / size);
  const std::int64_t below = -least / step, above = greatest / step;
  return {numbers, -below * step, step, static_cast<std::size_t>(below + above + 1)};
}

}  // namespace

MovedNumbers parse_numbers(std::string_view name, const PredicateEntry& entry) {
  const std::string text(name);
  const std::vector<ColumnGroup> groups = groups_of(entry);
  std::uint64_t triangle = 0, scene = 0;
  std::vector<std::string> whole, one;  // names that move several numbers, and one
  std::string guess;                    // "ax" and "a.X" are near
  for (const ColumnGroup& group : groups) {
    const std::uint64_t places = places_of(group);
    if (name == group.name) return {text, places};
    for (std::size_t k = 0; k < group.size && group.size == xyz.size(); ++k) {
      const std::string own = fmt::format("{}.{}", group.name, xyz[k]);
      if (name == own) return {text, one_bit<std::uint64_t>(group.first + k)};
      if (name.size() >= 2 && name.front() == group.name.front() && (name.back() | 0x20) == xyz[k]) guess = own;
      one.push_back(own);
    }
    if (group.size == 1) one.emplace_back(group.name);
    else whole.emplace_back(group.name);
    if (group.name == "a" || group.name == "b" || group.name == "c") triangle |= places;
    scene |= places;
  }
  if (name == "scene") return {text, scene};
  if (name == "triangle" && triangle != 0) return {text, triangle};
  // All but the first and the last of the vectors' numbers are left out: a.x, a.y, a.z, b.x ... p.z, r.
  constexpr std::size_t shown_first = 4;
  std::string names = fmt::format("{}", fmt::join(one.begin(), one.begin() + std::min(shown_first, one.size()), ", "));
  if (one.size() > shown_first + 2) names += fmt::format(" ... {}, {}", one[one.size() - 2], one.back());
  throw Error(
      fmt::format("'{}' is not a name of numbers of a query{} the names are {} and, with --exponents, {}{}, scene",
                  name, guess.empty() ? ";" : fmt::format("; did you mean '{}'?", guess), names, fmt::join(whole, ", "),
                  triangle != 0 ? ", triangle" : ""));
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
Plane exponent_plane(const Numbers<Real>& witness, const MovedNumbers& along, const MovedNumbers& across,
                     std::size_t size) {
  require_different(along, across);
  return {PlaneKind::exponents, exponent_side(witness, along, size), exponent_side(witness, across, size)};
}

template <class Real>
Numbers<Real> query_at(const Plane& plane, const Numbers<Real>& witness, std::size_t column, std::size_t row) {
  const std::int64_t along = plane.along.offset(column), across = plane.offset_of_row(row);
  Numbers<Real> v = witness;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const std::int64_t offset = (is_moved(plane.along, k) ? along : 0) + (is_moved(plane.across, k) ? across : 0);
    if (offset == 0) continue;  // keeps the sign of a witness's -0
    v[k] = plane.kind == PlaneKind::ulps ? moved_by_ulps(v[k], offset) : std::ldexp(v[k], static_cast<int>(offset));
  }
  return v;
}

#define AXISCERT_INSTANTIATE(Real)                                                                            \
  template Plane exponent_plane(const Numbers<Real>&, const MovedNumbers&, const MovedNumbers&, std::size_t); \
  template Numbers<Real> query_at(const Plane&, const Numbers<Real>&, std::size_t, std::size_t);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
