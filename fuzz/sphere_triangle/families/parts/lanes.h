// The first include of a file that makes queries in lanes: the portable headers, before any instruction set is chosen.
#pragma once

#ifndef HWY_COMPILE_ALL_ATTAINABLE
#define HWY_COMPILE_ALL_ATTAINABLE  // the narrow sets too: every machine tests that all make the same bytes
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/family.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/simd.h"
