// The one form of all images of a query, and the exact map from a query to an image of it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "exact/numbers/rational.h"
#include "fuzz/files/corpus.h"
#include "fuzz/shrink/pair.h"
#include "fuzz/sphere_triangle/families/parts/images.h"

namespace axiscert {
// The least of the 288 images (Symmetry) of A-P, B-P, C-P and r, as integers of which at least one is odd: that of
// every image by a symmetry, an exact translation and a power of two. Zeros have no sign. If a number is not finite,
// only the 288 images share it.
std::string least_image_text(const StoredQuery& stored);

// A map from a query to an image of it: another order of the vertices, a permutation and reflection of the
// axes, a power of two, a translation. No exact answer changes, except for the names of vertices.

// image = 2^exponent symmetry(query) + by, the translation for points only.
struct TriangleMap {
  Symmetry symmetry;
  int exponent = 0;
  std::array<Rational, 3> by;
};

// The first map, in the order of symmetries(), that makes `image` of `base`, exactly; both are valid. Empty if none
// does.
template <class Real>
std::optional<TriangleMap> map_between(const Query<Real>& base, const Query<Real>& image);

// The image of a valid query; empty if the precision cannot represent it.
template <class Real>
std::optional<Query<Real>> image_by(const TriangleMap& map, const Query<Real>& q);

const ImageMaps& sphere_triangle_image_maps();

}  // namespace axiscert
