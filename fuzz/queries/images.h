// The groups of fuzz/queries/image_groups.h, defined beside the families that make them: a function for each test that
// has some.
#pragma once

#include <span>

#include "fuzz/queries/image_groups.h"

namespace axiscert {

std::span<const ImageGroup* const> sphere_triangle_image_groups();
std::span<const ImageGroup* const> moving_sphere_image_groups();

}  // namespace axiscert
