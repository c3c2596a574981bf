// The sizes of boxes and triangles with which a kernel may compare an absolute number.
#pragma once

#include "fuzz/confirm/absolute_size.h"

namespace axiscert::boxes {

const Quantities& box_box_quantities();
const Quantities& box_triangle_quantities();

}  // namespace axiscert::boxes
