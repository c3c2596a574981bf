// The numbers beside the verdict of a capsule and a triangle, exactly. The capsule is its segment, made thicker by the
// radius: so they are those of the segment and the triangle, a box without breadth and a triangle, and the radius.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/boxes/contact.h"
#include "exact/judge/depth.h"
#include "exact/judge/exact_facts.h"
#include "exact/moving_sphere/motion_distance.h"

namespace axiscert::capsule {

using RationalPoint = boxes::Point;

// The first body is the capsule, the second the triangle.
class ExactContact {
 public:
  // Finite numbers, the end of the motion given, r >= 0.
  explicit ExactContact(const moving_sphere::GivenMotion& q);

  // The contact of the segment and the triangle. Where these are not apart, its directions are those in which a push
  // parts both pairs of bodies by the least way: the way of a thicker body is longer by r whatever the direction.
  const boxes::ExactContact& of_segment() const { return segment_; }
  const Rational& radius() const { return r_; }
  // One nearest point of the segment and one of the triangle.
  boxes::NearestPair nearest_points() const { return boxes::nearest_pair({end_[0], end_[1]}, boxes::hull_of(corner_)); }
  // Whether no other points are as near, of such a pair.
  bool is_only_pair(const boxes::NearestPair& pair) const {
    return boxes::is_only_pair(pair, normals().front(), {end_[0], end_[1]}, boxes::hull_of(corner_));
  }

  // As of two boxes.
  bool is_apart() const { return segment_.is_apart() && segment_.squared_separation() > r_ * r_; }
  bool is_deep() const;
  boxes::RootLess separation(const Rational& margin) const;
  double rounded_separation() const;
  const Rational& squared_scene() const { return scene_; }
  const std::vector<RationalPoint>& normals() const { return segment_.normals(); }
  std::optional<RationalPoint> only_normal() const { return segment_.only_normal(); }
  // The capsule's point is on its surface, relatively to 2^-240.
  std::optional<boxes::NearestPair> only_points() const;
  const Rational& squared_sides() const { return segment_.squared_separation(); }

  // 0 exactly of the right directions; else the exact share less at most 2^-229, rounded up: never more than the exact
  // one rounded up, so that a share of exactly 1/16 is not told as more.
  Decimal6 left(const RationalPoint& n) const;

  // 0 exactly where they are. The sizes are relatively within 2^-240; the mismatch is within 2^-240 of the roots whose
  // difference it is.
  double share_outside_of_a(const RationalPoint& p) const;
  double share_outside_of_b(const RationalPoint& p) const;
  double share_of_mismatch(const RationalPoint& a, const RationalPoint& b, bool any_way) const;

 private:
  bool is_right(const RationalPoint& n) const;
  // The penetration, below 0 where there is none, once the triangle is pushed by `way`; relatively to 2^-239.
  Rational rest_after(const RationalPoint& way) const;
  double share_of(const Rational& length) const;

  std::array<RationalPoint, 2> end_;
  std::array<RationalPoint, 3> corner_;
  Rational r_, scene_;
  boxes::ExactContact segment_;
};

// How far the query is from touching, as a share of the scene: of two that are in each other by the penetration.
ExactDepth exact_depth(const moving_sphere::GivenMotion& q);
std::vector<ExactFact> exact_facts(const moving_sphere::GivenMotion& q);

}  // namespace axiscert::capsule
