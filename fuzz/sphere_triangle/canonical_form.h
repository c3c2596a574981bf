// The one form of all images of a query.
#pragma once

#include <string>

#include "fuzz/files/corpus.h"

namespace axiscert {

// The least of the 288 images (Symmetry) of A-P, B-P, C-P and r, as integers of which at least one is odd: that of
// every image by a symmetry, an exact translation and a power of two. Zeros have no sign. If a number is not finite,
// only the 288 images share it.
std::string least_image_text(const StoredQuery& stored);

}  // namespace axiscert
