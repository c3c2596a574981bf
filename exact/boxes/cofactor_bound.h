// How deep a wrong verdict of box-box/cofactor can be: proved in exact/boxes/README.md.
#pragma once

namespace axiscert::boxes {

// Parts of the scene (squared_scene): the deepest missed contact by its penetration, the farthest phantom by its
// distance.
struct CofactorBound {
  double missed, phantom;
};

// 28 u + 5 d and 99 u + 30 d. u is half an ulp of 1 in the kernel's precision, 2^-24 or 2^-53; d the greatest defect of
// orthonormality of both boxes' axes (measures.h), at most 2^-10. Premises: round to nearest, no intermediate
// result overflows, and no product that is not 0 is below the normal numbers.
constexpr CofactorBound cofactor_bound(double u, double d) { return {28 * u + 5 * d, 99 * u + 30 * d}; }

// The same without rounding to whole numbers: the sums of the proof, term by term. Not above cofactor_bound.
CofactorBound cofactor_bound_in_full(double u, double d);

}  // namespace axiscert::boxes
