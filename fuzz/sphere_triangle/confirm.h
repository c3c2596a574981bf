// What sphere-triangle has for the record of a run, its witnesses and smaller queries.
#pragma once

#include "fuzz/confirm/absolute_size.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/queries/capabilities.h"

namespace axiscert {

const InputClasses& sphere_triangle_input_classes();
const NearestFeatures& sphere_triangle_nearest_features();
const Quantities& sphere_triangle_quantities();
const WitnessSides& sphere_triangle_witness_sides();

}  // namespace axiscert
