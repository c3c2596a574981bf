// The groups of fuzz/queries/images.h, where the families that make them are.
#pragma once

#include <span>

#include "fuzz/queries/images.h"

namespace axiscert {

std::span<const ImageGroup> image_groups();

}  // namespace axiscert
