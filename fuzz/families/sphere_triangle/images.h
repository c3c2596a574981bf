// The groups of fuzz/queries/images.h, defined beside the families that make them.
#pragma once

#include <span>

#include "fuzz/queries/images.h"

namespace axiscert {

std::span<const ImageGroup> image_groups();

}  // namespace axiscert
