// What a search and a map have of sphere-triangle.
#pragma once

#include "fuzz/search/confirm.h"
#include "fuzz/search/method.h"

namespace axiscert {
const SearchMethod& sphere_triangle_search();
const ProvedBounds& sphere_triangle_proved_bounds();

const AimValues& sphere_triangle_aim_values();

}  // namespace axiscert
