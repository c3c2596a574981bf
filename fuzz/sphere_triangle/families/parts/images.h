// Images of a query: by the symmetries of the predicate, which leave every exact answer unchanged except for the names
// of vertices, and in other units of length.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/random.h"
#include "kernel/query.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Vertex i of the image is vertex vertices[i] of the original, and its coordinate i is the original's coordinate
// axes[i], negated if bit i of `signs` is set.
struct Symmetry {
  std::array<std::uint8_t, 3> vertices, axes;
  std::uint8_t signs;
};
// Six vertex orders times 48 permutations and reflections of the axes; the first is the identity.
std::span<const Symmetry> symmetries();
inline constexpr std::size_t symmetry_count = 288;

// The image of a query over any numbers that have a minus.
template <class T>
Query<T> image(const Query<T>& q, const Symmetry& symmetry) {
  const auto mapped = [&](const Vec3<T>& v) {
    const std::array<const T*, 3> from = {&v.x, &v.y, &v.z};
    std::array<T, 3> to;
    for (std::size_t i = 0; i < 3; ++i) {
      const T& x = *from[symmetry.axes[i]];
      to[i] = has_bit(symmetry.signs, i) ? T(-x) : x;
    }
    return Vec3<T>{to[0], to[1], to[2]};
  };
  const std::array<const Vec3<T>*, 3> vertex = {&q.a, &q.b, &q.c};
  const auto at = [&](std::size_t i) { return mapped(*vertex[symmetry.vertices[i]]); };
  return {at(0), at(1), at(2), mapped(q.p), q.r};
}

}  // namespace axiscert

namespace axiscert::unit_images {
// Images of a query in other units of length: times powers of two within the range of forms of degree 6.

// The base, times the least power, times the greatest, and times one of each fifth of the others in turn.
inline constexpr std::size_t count = 8;

constexpr int exponent(const PowerRange& range, std::uint64_t base, std::size_t image) {
  constexpr std::size_t ends = 3;
  if (image == 0) return 0;
  if (image < ends) return image == 1 ? range.least : range.greatest;
  // The powers between the ends but 1, by number from below.
  const auto others = static_cast<std::uint64_t>(range.greatest - range.least - 2);
  const std::uint64_t part = image - ends, parts = count - ends;
  const std::uint64_t first = part * others / parts, after = (part + 1) * others / parts;
  const int power = range.least + 1 + static_cast<int>(first + base % (after - first));
  return power < 0 ? power : power + 1;
}

}  // namespace axiscert::unit_images

namespace axiscert {
// Groups of images, for the families that make them one query at a time.

// Fills the queries from position `first` on of groups of `size`: make(random, base) makes a base from its stream, and
// image(random, query, base, i) is its image number i, the base itself for 0. An image draws after its base, from the
// base's stream.
template <class Real, class Make, class Image>
void fill_groups(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out, std::uint64_t size,
                 const Make& make, const Image& image) {
  for (std::size_t i = 0; i < out.size;) {
    const std::uint64_t base = (first + i) / size;
    Stream random(name, base);
    const auto q = make(random, base);
    for (; i < out.size && (first + i) / size == base; ++i) {
      Stream after = random;
      out.set(i, image(after, q, base, static_cast<std::size_t>((first + i) % size)));
    }
  }
}

}  // namespace axiscert
