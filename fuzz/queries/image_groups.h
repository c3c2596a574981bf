// Families of images: a base query, followed by the same query rotated, mirrored, moved or scaled, exactly; a motion
// turned round, in parts, or going on. The exact answers to a query and its images agree, except for the names of
// comparisons; if a kernel's answers differ, that is an asymmetry (fuzz/confirm/asymmetry.h).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/queries/floats.h"
#include "kernel/base/enums.h"
#include "kernel/base/geometry.h"
#include "kernel/names.h"
#include "kernel/predicate.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Exponents m of factors 2^m by which queries are scaled.

// Both ends included; of the factor of every number.
struct ExponentWindow {
  int low, high;
  int width() const { return high - low + 1; }
  bool operator==(const ExponentWindow&) const = default;
};

// All that are scanned. Numbers that are multiples of u below 2 can be scaled by them exactly: u 2^m must not be below
// the least subnormal number, and 2 2^m must not exceed the greatest power of two.
inline ExponentWindow scanned_exponents(Precision precision) {
  if (precision == Precision::binary32)
    return {std::numeric_limits<float>::min_exponent, std::numeric_limits<float>::max_exponent - 1};
  return {std::numeric_limits<double>::min_exponent, std::numeric_limits<double>::max_exponent - 1};
}

// How an image is made of its base: the vertices in another order; the axes exchanged, some of them turned round or
// not; signs changed alone; all numbers times a power of two; all points moved; a motion from its end to its start; one
// in two parts, the second from where the first ends, which touch where one of them does; one of which the base is a
// half, a quarter or an eighth, which is in contact where the base is; two bodies exchanged; a body turned so that it
// is the same one.
enum class ImageKind : std::uint8_t { order, axes, mirror, scale, translation, reversal, split, halving, swap, turn };
template <>
inline constexpr std::size_t enum_count<ImageKind> = 10;
inline constexpr EnumArray<ImageKind, std::string_view> image_kind_names = {
    "order", "axes", "mirror", "scale", "translation", "reversal", "split", "halving", "swap", "turn"};
constexpr std::string_view name(ImageKind which) { return image_kind_names[which]; }

// Whether the verdict on the base decides that on an image of this kind: a motion may meet what its half does not.
constexpr bool decides_image(ImageKind kind, Verdict base) {
  return kind != ImageKind::halving || base == Verdict::contact;
}
// Whether the comparisons of such an image are others than the base's.
constexpr bool has_own_comparisons(ImageKind kind) {
  return kind == ImageKind::reversal || kind == ImageKind::split || kind == ImageKind::halving ||
         kind == ImageKind::swap;
}

// The powers of two from 2^least to 2^greatest.
struct PowerRange {
  int least, greatest;
  constexpr bool contains(int exponent) const { return least <= exponent && exponent <= greatest; }
};

struct ImageGroup {
  const Predicate& (*predicate)();
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
  // So many queries after each other are one image: separated where all of them are, and in contact where any is.
  std::size_t parts = 1;
};
// The group of a family; null if the family makes no images.
const ImageGroup* image_group(std::string_view family);
// The groups of all predicates.
std::vector<const ImageGroup*> image_groups();

// The comparisons of images by their names in the base: for an image whose B and C are the base's A and B,
// vertex_b.side_c is the base's vertex_a.side_b. The names of a predicate's comparisons tell its vertices: "vertex_a",
// "side_a", "edge_ab".
class ComparisonsOfBase {
 public:
  // Throws HarnessFault where a comparison has no name in the base.
  ComparisonsOfBase(const Predicate& predicate, const std::array<std::uint8_t, 3>& order);
  ComparisonBits operator()(ComparisonBits image) const;

 private:
  std::vector<std::uint8_t> base_;  // by comparison of the image
};

// The query in another unit of length: every number times 2^exponent, rounded where it leaves the range.
template <class Real>
Query<Real> times_power(const Query<Real>& q, int exponent) {
  auto v = coordinates(q);
  scale_by_power_of_two(v, exponent);
  return from_coordinates(v);
}
// The same of any predicate, every number of which is a length, a place or a direction.
template <class Real>
Numbers<Real> times_power(const Numbers<Real>& numbers, int exponent) {
  Numbers<Real> v = numbers;
  scale_by_power_of_two(v, exponent);
  return v;
}

}  // namespace axiscert

namespace axiscert::exact_images {
// Images of a query of any predicate by the roles and groups of its columns: nothing is rounded but where a sum is that
// the caller has to leave room for.

// Whether the columns from `first` on are the three of a place or a direction.
inline bool is_vector(const PredicateEntry& entry, std::size_t first) {
  const auto& columns = entry.columns;
  const auto is_role = [&](std::size_t k) {
    return columns[k].role == Role::coordinate || columns[k].role == Role::direction;
  };
  return first + 3 <= columns.size() && is_role(first) && columns[first].group == columns[first + 1].group &&
         columns[first].group == columns[first + 2].group;
}

// Coordinate i of every vector of the image is coordinate axes[i] of the original, negated if bit i of `signs` is set.
template <class Real>
Numbers<Real> with_axes(const Numbers<Real>& numbers, const PredicateEntry& entry,
                        const std::array<std::uint8_t, 3>& axes, std::uint8_t signs) {
  Numbers<Real> image = numbers;
  for (std::size_t k = 0; k < numbers.size(); k += is_vector(entry, k) ? 3 : 1) {
    if (!is_vector(entry, k)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real x = numbers[k + axes[i]];
      image[k + i] = has_bit(signs, i) ? -x : x;
    }
  }
  return image;
}

// Vertex i of the image is vertex order[i] of the original; the vertices are the first three groups of three columns.
template <class Real>
Numbers<Real> with_order(const Numbers<Real>& numbers, const std::array<std::uint8_t, 3>& order) {
  Numbers<Real> image = numbers;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0; i < 3; ++i) image[3 * v + i] = numbers[3 * std::size_t{order[v]} + i];
  }
  return image;
}

// Every place moved; directions and lengths stay. One rounding a coordinate.
template <class Real>
Numbers<Real> moved(const Numbers<Real>& numbers, const PredicateEntry& entry, const portable::Vec3<Real>& by) {
  Numbers<Real> image = numbers;
  const std::array<Real, 3> step = {by.x, by.y, by.z};
  for (std::size_t k = 0; k < numbers.size(); k += is_vector(entry, k) ? 3 : 1) {
    if (!is_vector(entry, k) || entry.columns[k].role != Role::coordinate) continue;
    for (std::size_t i = 0; i < 3; ++i) image[k + i] = numbers[k + i] + step[i];
  }
  return image;
}

}  // namespace axiscert::exact_images
