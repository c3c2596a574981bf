// The groups of fuzz/queries/image_groups.h, defined beside the families that make them.
#pragma once

#include <span>

#include "fuzz/queries/image_groups.h"

namespace axiscert {

std::span<const ImageGroup* const> image_groups();

}  // namespace axiscert
