// Families of images: a base query, followed by the same query rotated, mirrored, moved or scaled, exactly. The exact
// answers to a query and its images agree, except for the names of the vertices; if a kernel's answers differ, that is
// an asymmetry (fuzz/confirm/asymmetry.h).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "kernel/sphere_triangle/names.h"

namespace axiscert {

struct ImageGroup {
  std::string_view family;
  std::size_t size;  // queries that share a base, the base first: position p is image p % size of base p / size
  // Vertex i of the image is vertex order[i] of the base.
  std::array<std::uint8_t, 3> (*order)(std::size_t image);
};
// The group of a family; null if the family makes no images.
const ImageGroup* image_group(std::string_view family);

// The comparisons of an image by their names in the base: for an image whose B and C are the base's A and B, the bit of
// vertex_b.side_c becomes that of vertex_a.side_b.
ComparisonBits bits_of_base(ComparisonBits image, const std::array<std::uint8_t, 3>& order);

}  // namespace axiscert
