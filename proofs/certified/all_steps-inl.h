// The steps that forms.cpp includes for one of Highway's instruction sets, for one that records. No include guard:
// included once for each HWY_NAMESPACE.
#include "proofs/certified/highway-inl.h"

#include "kernel/base/geometry.h"
#undef AXISCERT_INLINE  // inlined, the steps take a minute to compile
#define AXISCERT_INLINE inline

#include "kernel/sphere_triangle/certified/coarse_step-inl.h"
#include "kernel/sphere_triangle/certified/box_step-inl.h"
#include "kernel/sphere_triangle/certified/conservative_step-inl.h"
#include "kernel/sphere_triangle/certified/range_step-inl.h"
#include "kernel/sphere_triangle/certified/margins-inl.h"
#include "kernel/sphere_triangle/certified/fine_step-inl.h"
#include "kernel/sphere_triangle/certified/pairs-inl.h"
#include "kernel/sphere_triangle/certified/wrapped-inl.h"
#include "kernel/sphere_triangle/certified/deep_step-inl.h"
#include "kernel/sphere_triangle/certified/pair_step-inl.h"

#include "proofs/certified/steps-inl.h"
