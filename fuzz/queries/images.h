// Families of images: a base query, and after it the same query turned, mirrored, moved or scaled, exactly. No exact
// answer differs between a query and its images, but for the names of the vertices; where a kernel's does, that is an
// asymmetry (fuzz/confirm/asymmetry.h).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "kernel/names.h"

namespace axiscert {

struct ImageGroup {
  std::string_view family;
  std::size_t size;  // queries that share a base, the base first: position p is image p % size of base p / size
  // Image's vertex i is vertex order[i] of the base.
  std::array<std::uint8_t, 3> (*order)(std::size_t image);
};
// That of a family; null where the family makes no images.
const ImageGroup* image_group(std::string_view family);

// The comparisons of an image by their names in the base: bit of vertex_b.side_c of an image whose B and C are the
// base's A and B is that of vertex_a.side_b.
ComparisonBits bits_of_base(ComparisonBits image, const std::array<std::uint8_t, 3>& order);

}  // namespace axiscert
