#include "fuzz/queries/image_groups.h"

#include "fuzz/queries/images.h"

namespace axiscert {
namespace {

// A comparison by its meaning: the vertices of its feature, bit i for vertex i, and the vertex of its side, 3 for a
// radius.
struct Meaning {
  unsigned feature, side;
  bool operator==(const Meaning&) const = default;
};
constexpr std::array<Meaning, comparison_count> meanings = {{{7, 3},  // plane
                                                             {1, 3},
                                                             {1, 1},
                                                             {1, 2},  // vertices
                                                             {2, 3},
                                                             {2, 0},
                                                             {2, 2},
                                                             {4, 3},
                                                             {4, 0},
                                                             {4, 1},
                                                             {3, 3},
                                                             {3, 2},  // edges
                                                             {6, 3},
                                                             {6, 0},
                                                             {5, 3},
                                                             {5, 1}}};

Meaning in_base(const Meaning& image, const std::array<std::uint8_t, 3>& order) {
  Meaning base{0, image.side == 3 ? 3u : order[image.side]};
  for (unsigned i = 0; i < 3; ++i) {
    if (has_bit(image.feature, i)) base.feature |= one_bit<unsigned>(order[i]);
  }
  return base;
}

}  // namespace

const ImageGroup* image_group(std::string_view family) {
  for (const ImageGroup* group : image_groups()) {
    if (group->family == family) return group;
  }
  return nullptr;
}

ComparisonBits bits_of_base(ComparisonBits image, const std::array<std::uint8_t, 3>& order) {
  ComparisonBits bits = 0;
  for_each_bit(image, [&](std::size_t k) {
    const Meaning meaning = in_base(meanings[k], order);
    std::size_t base = 0;
    while (meanings[base] != meaning) ++base;
    bits |= one_bit<ComparisonBits>(base);
  });
  return bits;
}

}  // namespace axiscert
