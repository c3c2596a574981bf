// Traits of a moving sphere and a triangle.
#pragma once

#include "fuzz/queries/capabilities.h"

namespace axiscert {

const Traits& moving_sphere_traits();

}  // namespace axiscert
