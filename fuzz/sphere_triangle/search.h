// What a search and a map have of sphere-triangle.
#pragma once

#include "fuzz/search/method.h"
#include "fuzz/search/proved.h"

namespace axiscert {

const SearchMethod& sphere_triangle_search();
const ProvedBounds& sphere_triangle_proved_bounds();

}  // namespace axiscert
