// The first time at which a moving sphere touches a triangle, exactly, and what it touches then; and what else exact
// arithmetic tells of a motion besides its verdict.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/judge/contact_judgement.h"
#include "exact/judge/exact_facts.h"
#include "exact/moving_sphere/motion_distance.h"
#include "exact/numbers/roots.h"

namespace axiscert::moving_sphere {

// The number rest - sqrt(square), for a square that is not negative.
struct RootTime {
  Rational rest, square;
};

// The sign of value + slope t.
int sign_at(const RootTime& t, const Rational& value, const Rational& slope);
// The sign of t - s.
inline int compare(const RootTime& t, const Rational& s) { return sign_at(t, -s, 1); }

// Whether sphere and triangle have a point in common before the motion: more than touching, just touching, none, which
// is so too where there is no contact at all.
enum class Start : std::uint8_t { overlap, touching, clear };

}  // namespace axiscert::moving_sphere

namespace axiscert {
template <>
inline constexpr std::size_t enum_count<moving_sphere::Start> = 3;
}  // namespace axiscert

namespace axiscert::moving_sphere {

inline constexpr EnumArray<Start, std::string_view> start_names = {"overlap", "touching", "clear"};

struct FirstContact {
  Start start;
  RootTime time;        // t* in [0, 1]: the least t with |P + t D - X| <= r for an X of the closed triangle
  FeatureSet features;  // all that are nearest to the centre at t*; a kernel that names one of them is right
};

// The point of one part of the triangle that is nearest to the centre, at the time t: from + along t. It is seen from
// P, in the motion's unit.
struct MovingPoint {
  portable::Vec3<Rational> from, along;
};
MovingPoint nearest_point(const MotionPieces& motion, Feature feature);
inline portable::Vec3<Rational> rationals(const portable::Vec3<mpz_class>& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

// For every query of finite numbers with r >= 0, any triangle and any D. Empty where there is no contact in [0, 1].
//
// Over the pieces in their order, the squared distance first falls to r^2 at the beginning of a piece, which is
// rational, or at the lesser root (b - sqrt(b^2 - a c)) / a of its parabola less r^2. No two roots are compared.
std::optional<FirstContact> first_contact(const GivenMotion& q);
// The same with the pieces of the query's motion at hand.
std::optional<FirstContact> first_contact(const GivenMotion& q, const MotionPieces& motion);

// Whether a kernel with this policy promises to be right on the query, exactly.
bool is_promised(const MotionPolicy& policy, const GivenMotion& q);

// The greatest number of the precision that is not greater than t, for t in [0, 1]: the best time that is not late.
template <class Real>
Real rounded_down(const RootTime& t);

// Sizes of what a kernel's measures are wrong by. They are rounded to be shown; what is decided is decided elsewhere.

// |t - s|, and t >= 0 itself, relatively to 2^-250: nothing cancels.
Rational apart(const RootTime& t, const Rational& s);
inline Rational approximate(const RootTime& t) { return apart(t, 0); }
// |t - s| times a length whose square is given, rounded once to the nearest binary64; at most the greatest. `about` is
// apart(t, s).
double rounded_apart(const RootTime& t, const Rational& s, const Rational& about, const Rational& squared_length);

// The tunnel of a motion whose least squared distance is given, at most r^2.
Tunnel tunnel_of(const Rational& r, const Rational& least_squared);

// The square of the scene's extent: the greatest of r and the distances of the prism's corners, A to C' = C - D, from
// P.
Rational squared_scene(const GivenMotion& q);

}  // namespace axiscert::moving_sphere

namespace axiscert::moving_sphere {

// The place of the first contact, each coordinate exactly: of the triangle's point that is nearest to the centre then,
// and of the unit vector from there to the centre, empty where they are one point.
struct ExactPlace {
  std::array<RootNumber, 3> point;
  std::vector<RootNumber> normal;
};
ExactPlace exact_place(const GivenMotion& q, const MotionPieces& motion, const FirstContact& contact);

// The query is valid.
std::vector<ExactFact> exact_facts(const GivenMotion& q);

}  // namespace axiscert::moving_sphere
