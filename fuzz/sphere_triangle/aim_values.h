#pragma once

#include "fuzz/search/confirm.h"

namespace axiscert {

const AimValues& sphere_triangle_aim_values();

}  // namespace axiscert
