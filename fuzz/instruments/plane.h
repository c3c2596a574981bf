// A plane through query space around a witness: determines the query of each pixel.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "kernel/query.h"
#include "kernel/predicate.h"

namespace axiscert {

// Numbers of a query that move together; bit k is column k.
struct MovedNumbers {
  std::string name;  // "a.x", "r"; "a", "triangle", "scene"
  std::uint64_t places;
};
// One number of the entry, by its group and x, y or z where the group has three; a group; the triangle (a, b and c) or
// the scene (all of them). Throws Error that lists the valid names.
MovedNumbers parse_numbers(std::string_view name, const PredicateEntry& entry);

// From pixel to pixel a number changes by ulps, through zero to the other sign; or by powers of two.
enum class PlaneKind : std::uint8_t { ulps, exponents };
template <>
inline constexpr std::size_t enum_count<PlaneKind> = 2;
inline constexpr EnumArray<PlaneKind, std::string_view> plane_kind_names = {"ulps", "exponents"};
constexpr std::string_view name(PlaneKind which) { return plane_kind_names[which]; }

struct PlaneSide {
  MovedNumbers numbers;
  std::int64_t first, step;  // the offset of pixel i is first + i * step; one pixel has offset 0
  std::size_t pixels;

  std::int64_t offset(std::size_t pixel) const { return first + static_cast<std::int64_t>(pixel) * step; }
  std::size_t origin() const { return static_cast<std::size_t>(-first / step); }  // the pixel with offset 0
};

// Column i is pixel i along; row 0, the uppermost, is the last pixel across.
struct Plane {
  PlaneKind kind;
  PlaneSide along, across;

  std::size_t columns() const { return along.pixels; }
  std::size_t rows() const { return across.pixels; }
  std::int64_t offset_of_row(std::size_t row) const { return across.offset(rows() - 1 - row); }
};

// `size` pixels in each direction, `ulps` from one to the next, with the witness in the middle. The limits ensure that
// an offset ends among the NaNs of binary32 and never wraps to a number again: 2^11 * 2^12 = 2^23 ulps, and beyond
// infinity there are 2^23 - 1 patterns.
inline constexpr std::size_t greatest_map = 4096;
inline constexpr std::int64_t greatest_ulps = 4096;
// Throws Error if a side moves more than one number, or both sides move the same number.
Plane ulp_plane(const MovedNumbers& along, const MovedNumbers& across, std::size_t size, std::int64_t ulps);

// Every power of two at which the greatest of the moved numbers is a nonzero number of the precision: 277 pixels in
// binary32, 2098 in binary64, or every second, third ... if these are more than `size`. Numbers that are moved by both
// sides are moved twice. Throws Error if all numbers of a side are zero, or both sides move the same numbers.
template <class Real>
Plane exponent_plane(const Numbers<Real>& witness, const MovedNumbers& along, const MovedNumbers& across,
                     std::size_t size);

// The query of a pixel. It is not valid beyond the numbers of the precision, or if the radius is below zero; a number
// that a power of two moves into the subnormals is rounded to nearest, once.
template <class Real>
Numbers<Real> query_at(const Plane& plane, const Numbers<Real>& witness, std::size_t column, std::size_t row);

}  // namespace axiscert
