// Sizes of what a kernel's measures are wrong by. They are rounded to be shown; what is decided is decided elsewhere.
#pragma once

#include "exact/judge/motion_judgement.h"
#include "exact/moving_sphere/first_contact.h"

namespace axiscert::moving_sphere {

// Not above sqrt(q), and relatively less than 2^-250 below it; q >= 0.
Rational root_below(const Rational& q);

// |t - s|, and t >= 0 itself, relatively to 2^-250: nothing cancels.
Rational apart(const RootTime& t, const Rational& s);
inline Rational approximate(const RootTime& t) { return apart(t, 0); }

// The tunnel of a motion whose least squared distance is given, at most r^2.
Tunnel tunnel_of(const Rational& r, const Rational& least_squared);

// The angle between two vectors in radians, rounded to the nearest binary64 from its sine; pi where one is zero.
double angle_between(const portable::Vec3<Rational>& a, const portable::Vec3<Rational>& b);

// The square of the scene's extent: the greatest of r and the distances of the prism's corners, A to C' = C - D, from
// P.
Rational squared_scene(const GivenMotion& q);

}  // namespace axiscert::moving_sphere
