// A plane through query space around a witness: which query a pixel stands for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/query.h"

namespace axiscert {

// Numbers of a query that move together; bit k is coordinate k.
struct MovedNumbers {
  std::string name;  // "a.x", "r"; "a", "triangle", "scene"
  std::uint16_t places;
};
// One of the thirteen coordinates, a point, the triangle (A, B and C) or the scene (all thirteen). Throws Error naming
// what there is.
MovedNumbers parse_numbers(std::string_view name);

// From pixel to pixel a number moves by ulps, through zero to the other sign; or by powers of two.
enum class PlaneKind : std::uint8_t { ulps, exponents };
inline constexpr std::array<std::string_view, 2> plane_kind_names = {"ulps", "exponents"};

struct PlaneSide {
  MovedNumbers numbers;
  std::int64_t first, step;  // the offset of pixel i is first + i * step; of one pixel it is 0
  std::size_t pixels;

  std::int64_t offset(std::size_t pixel) const { return first + static_cast<std::int64_t>(pixel) * step; }
  std::size_t origin() const { return static_cast<std::size_t>(-first / step); }  // the pixel of offset 0
};

// Column i is pixel i along; row 0, the uppermost, is the last pixel across.
struct Plane {
  PlaneKind kind;
  PlaneSide along, across;

  std::size_t columns() const { return along.pixels; }
  std::size_t rows() const { return across.pixels; }
  std::int64_t offset_of_row(std::size_t row) const { return across.offset(rows() - 1 - row); }
};

// `size` pixels each way, `ulps` from one to the next, the witness in the middle. At most these, so that an offset ends
// among the NaNs of binary32 and never wraps to a number again: 2^11 * 2^12 = 2^23 ulps, and beyond infinity there are
// 2^23 - 1 patterns.
inline constexpr std::size_t greatest_map = 4096;
inline constexpr std::int64_t greatest_ulps = 4096;
// Throws Error where a side moves more than one number, or both the same.
Plane ulp_plane(const MovedNumbers& along, const MovedNumbers& across, std::size_t size, std::int64_t ulps);

// Every power of two at which the greatest of the moved numbers is a number of the precision other than zero: 277
// pixels in binary32, 2098 in binary64, or every second, third ... where these are more than `size`. Numbers that both
// sides move are moved by both. Throws Error where all numbers of a side are zero, or both sides move the same.
template <class Real>
Plane exponent_plane(const Query<Real>& witness, const MovedNumbers& along, const MovedNumbers& across,
                     std::size_t size);

// The query of a pixel. Beyond the numbers of the precision, and at a radius below zero, it is no valid one; a number
// that a power of two takes among the subnormals is rounded to nearest, once.
template <class Real>
Query<Real> query_at(const Plane& plane, const Query<Real>& witness, std::size_t column, std::size_t row);

}  // namespace axiscert
