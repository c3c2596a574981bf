#include "fuzz/sphere_triangle/families/parts/images.h"

#include <algorithm>

namespace axiscert {
namespace {

std::array<Symmetry, symmetry_count> all_symmetries() {
  std::array<Symmetry, symmetry_count> all;
  std::size_t n = 0;
  std::array<std::uint8_t, 3> vertices = {0, 1, 2};
  do {
    std::array<std::uint8_t, 3> axes = {0, 1, 2};
    do {
      for (std::uint8_t signs = 0; signs < 8; ++signs) all[n++] = {vertices, axes, signs};
    } while (std::next_permutation(axes.begin(), axes.end()));
  } while (std::next_permutation(vertices.begin(), vertices.end()));
  return all;
}

}  // namespace

std::span<const Symmetry> symmetries() {
  static const std::array<Symmetry, symmetry_count> all = all_symmetries();
  return all;
}

}  // namespace axiscert
