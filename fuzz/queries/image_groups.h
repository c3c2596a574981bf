// Families of images: a base query, followed by the same query rotated, mirrored, moved or scaled, exactly. The exact
// answers to a query and its images agree, except for the names of the vertices; if a kernel's answers differ, that is
// an asymmetry (fuzz/confirm/asymmetry.h).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "kernel/base/enum_array.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// How an image is made of its base: the vertices in another order; the axes exchanged, some of them turned round or
// not; signs changed alone; all numbers times a power of two; all points moved.
enum class ImageKind : std::uint8_t { order, axes, mirror, scale, translation };
template <>
inline constexpr std::size_t enum_count<ImageKind> = 5;
inline constexpr EnumArray<ImageKind, std::string_view> image_kind_names = {"order", "axes", "mirror", "scale",
                                                                            "translation"};

// The powers of two from 2^least to 2^greatest.
struct PowerRange {
  int least, greatest;
  constexpr bool contains(int exponent) const { return least <= exponent && exponent <= greatest; }
};

struct ImageGroup {
  std::string_view family;
  std::size_t size;  // queries that share a base, the base first: position p is image p % size of base p / size
  // Vertex i of the image is vertex order[i] of the base.
  std::array<std::uint8_t, 3> (*order)(std::size_t image);
  ImageKind (*kind)(std::size_t image);  // for an image other than the base
  // The power of two of an image of the kind `scale` of base number `base`.
  int (*exponent)(Precision precision, std::uint64_t base, std::size_t image) = nullptr;
  // The powers of two times which no form of degree 6 in the base's differences overflows or underflows; null where
  // that is not known of every base.
  PowerRange (*range)(Precision precision) = nullptr;
};
// The group of a family; null if the family makes no images.
const ImageGroup* image_group(std::string_view family);

// The comparisons of an image by their names in the base: for an image whose B and C are the base's A and B, the bit of
// vertex_b.side_c becomes that of vertex_a.side_b.
ComparisonBits bits_of_base(ComparisonBits image, const std::array<std::uint8_t, 3>& order);

// The query in another unit of length: every number times 2^exponent, rounded where it leaves the range.
template <class Real>
Query<Real> times_power(const Query<Real>& q, int exponent) {
  auto v = coordinates(q);
  for (Real& x : v) x = std::ldexp(x, exponent);
  return from_coordinates(v);
}

}  // namespace axiscert
