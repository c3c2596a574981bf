// Families of images: a base query, followed by the same query rotated, mirrored, moved or scaled, exactly; a motion
// turned round, in parts, or going on. The exact answers to a query and its images agree, except for the names of
// comparisons; if a kernel's answers differ, that is an asymmetry (fuzz/confirm/asymmetry.h).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/base/enum_array.h"
#include "kernel/base/powers_of_two.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/predicate.h"

namespace axiscert {

// How an image is made of its base: the vertices in another order; the axes exchanged, some of them turned round or
// not; signs changed alone; all numbers times a power of two; all points moved; a motion from its end to its start; one
// in two parts, the second from where the first ends, which touch where one of them does; one of which the base is a
// half, a quarter or an eighth, which is in contact where the base is.
enum class ImageKind : std::uint8_t { order, axes, mirror, scale, translation, reversal, split, halving };
template <>
inline constexpr std::size_t enum_count<ImageKind> = 8;
inline constexpr EnumArray<ImageKind, std::string_view> image_kind_names = {
    "order", "axes", "mirror", "scale", "translation", "reversal", "split", "halving"};
constexpr std::string_view name(ImageKind which) { return image_kind_names[which]; }

// Whether the verdict on the base decides that on an image of this kind: a motion may meet what its half does not.
constexpr bool decides_image(ImageKind kind, Verdict base) {
  return kind != ImageKind::halving || base == Verdict::contact;
}
// Whether the comparisons of such an image are others than the base's.
constexpr bool has_own_comparisons(ImageKind kind) {
  return kind == ImageKind::reversal || kind == ImageKind::split || kind == ImageKind::halving;
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
