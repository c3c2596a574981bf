// The numbers beside the verdict of two boxes, or of a box and a triangle, exactly: separation, normals and points, and
// how far a given normal and given points are from being right.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "exact/boxes/measures.h"

namespace axiscert::boxes {

// A direction in which the second body can be pushed, as one of the axes has it: after `rest / |along|` of it that axis
// parts the bodies. `rest` is negative where it parts them already.
struct Push {
  Point along;
  Rational rest, squared_length;
  Rational squared;  // of that length of the push, in contact
};

inline double at_most_finite(double x) { return std::min(x, std::numeric_limits<double>::max()); }

// sqrt(squared) - less, or its negative.
struct RootLess {
  Rational squared, less;
  bool is_negated;
};

// The second body less `way` touches the first where they are apart; with it added where they are in contact. No
// shorter way does it.
class ExactContact {
 public:
  explicit ExactContact(const ExactPair& q);
  explicit ExactContact(const ExactBoxAndTriangle& q);

  // Apart, with a distance above 0. Touching bodies are not: their distance is 0, and so is their penetration.
  bool is_apart() const { return is_apart_; }
  // The square of the separation: of the distance where apart, else of the penetration.
  const Rational& squared_separation() const { return squared_; }
  // The separation less a margin, and the nearest number to the separation.
  RootLess separation(const Rational& margin) const {
    return is_apart_ ? RootLess{squared_, margin, false} : RootLess{squared_, Rational(-margin), true};
  }
  double rounded_separation() const;
  // In contact, with a penetration that is not 0.
  bool is_deep() const { return !is_apart_ && squared_ != 0; }
  // The square of the distance or penetration by which the two are on one side of each other: a smaller rounding cannot
  // turn the normal round.
  const Rational& squared_sides() const { return squared_; }
  const Rational& squared_scene() const { return scene_; }

  // Every direction in which a push as long as the penetration parts them, each once; of bodies apart, the one from the
  // nearest point of the first to that of the second. They are of any length.
  const std::vector<Point>& normals() const { return normals_; }
  // That one; empty where there are several.
  std::optional<Point> only_normal() const;
  // The axes that decide, as deciding() has them.
  const std::vector<std::size_t>& least_axes() const { return least_axes_; }

  // The point of each body that touches the other after the way of the only normal; empty where other pairs do too, or
  // there are several normals. Found when it is asked for first.
  const std::optional<NearestPair>& only_points() const;

  // What is left of the penetration, as a share of it, when the second body is pushed by the exact penetration along a
  // vector n that is not 0: the least over all pushes u of (rest_u / |u| - d u.n / |u| |n|) / d, d the penetration.
  // It is at most 2, 0 exactly where n has one of the directions `normals`, and at most 1 - cos(t) at an angle t to
  // one. Rounded up once: it is above a number F of at most six digits exactly where the share is. Precondition: in
  // contact, and the penetration is not 0.
  Decimal6 left(const Point& n) const;
  // The sign of that share less F.
  int compare_left(const Point& n, const Rational& f) const;

  // The square of a point's distance from its body.
  Rational squared_distance_from_a(const Point& p) const { return in_squares(squared_distance({p * unit_}, a_)); }
  Rational squared_distance_from_b(const Point& p) const { return in_squares(squared_distance({p * unit_}, b_)); }

  // A push of the second body by a - b against the shortest that parts the bodies: by how much it is longer than the
  // penetration, or how much of that is left then, whichever is more. For bodies apart | |a - b| - distance |. It is 0
  // exactly where a and b, points of the bodies, are right; else relatively within 2^-240. `any_way`: the length alone
  // counts.
  Rational mismatch(const Point& a, const Point& b, bool any_way = false) const;

  // The two distances and the mismatch as shares of the scene, rounded; 0 in a scene of one point.
  double share_outside_of_a(const Point& p) const { return share_of(squared_distance_from_a(p)); }
  double share_outside_of_b(const Point& p) const { return share_of(squared_distance_from_b(p)); }
  double share_of_mismatch(const Point& a, const Point& b, bool any_way) const {
    const Rational off = mismatch(a, b, any_way);
    return share_of(off * off);
  }

 private:
  // The bodies in units of length that make all numbers integers: quotients of rationals would take twice as long.
  template <class Bodies>
  struct InUnits;
  template <class Bodies>
  explicit ExactContact(const InUnits<Bodies>& q);
  double share_of(const Rational& squared) const;
  Rational in_squares(const Rational& squared) const { return squared / (unit_ * unit_); }
  void find_apart();
  void find_in_contact();
  std::optional<NearestPair> touching_points() const;
  const Push& least() const { return pushes_[least_]; }
  // The penetration, below 0 where there is none, once the second body is pushed by `way`; relatively to 2^-240.
  Rational rest_after(const Point& way) const;
  // That of one push, relatively to 2^-240: a sum of two shares that are not negative. The first alone is above `share`
  // where the push is longer than 1 + share times the least.
  Rational approximate_left(const Push& push, const Point& n) const;
  bool is_longer(const Push& push, const Rational& share) const {
    return push.squared > (1 + share) * (1 + share) * least().squared;
  }

  Rational unit_;  // so many units are 1; the bodies and the pushes are in units
  Hull a_, b_;
  std::vector<Push> pushes_;  // both ways of each axis
  std::size_t least_ = 0;
  Rational scene_, squared_;
  bool is_apart_ = false;
  std::vector<Point> normals_;
  std::vector<std::size_t> least_axes_;
  std::optional<NearestPair> nearest_;  // of bodies apart
  mutable std::optional<std::optional<NearestPair>> points_;
};

}  // namespace axiscert::boxes
