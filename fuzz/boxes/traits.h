// Traits of two boxes, and of a box and a triangle.
#pragma once

#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Traits& box_box_traits();
const Traits& box_triangle_traits();

}  // namespace axiscert
