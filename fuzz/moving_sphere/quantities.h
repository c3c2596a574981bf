// The sizes in a motion with which a kernel may compare an absolute number.
#pragma once

#include "fuzz/confirm/absolute_size.h"

namespace axiscert::moving_sphere {

const Quantities& quantities();

}  // namespace axiscert::moving_sphere
