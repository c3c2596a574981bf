// Whether a moving sphere is clear of a triangle: the verdict of the twenty axes, never wrong.
#pragma once

#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::character {

// Whether the closed solid sphere has nowhere on its way a point in common with the closed triangle. For every query of
// finite numbers with r >= 0, of any area and displacement; exact, without a tolerance.
//
// The comparisons of moving-sphere/twenty-nonstrict over enclosures of binary64: an axis of which each comparison is
// certain separates, and where no axis can separate there is contact. What that leaves open is decided by the same
// comparisons over rationals. Over the reals an axis that separates does so rightly, and with `>=` in the sides one
// separates wherever there is no contact (docs/moving.md).
bool is_clear(const MovingQuery<float>& q);

// The two ways, for tests: the enclosures alone, empty where they are not certain, and the rationals alone.
enum class Clearance { clear, contact, open };
Clearance clearance_by_enclosures(const MovingQuery<float>& q);
bool is_clear_by_rationals(const MovingQuery<float>& q);

}  // namespace axiscert::character
