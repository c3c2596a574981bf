// Boxes, and a box and a triangle, over the rationals, made of a query's numbers without rounding; how deep they are in
// contact, and how far apart.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "exact/boxes/nearest.h"
#include "exact/boxes/scaled.h"
#include "exact/judge/depth.h"
#include "exact/judge/exact_facts.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {

using ExactBox = OrientedBox<Rational>;
using ExactPair = BoxPair<Rational>;

// Precondition: the numbers are finite, and no quaternion is 0. The centre and half extents of two corners are exact.
ExactPair exact_pair(const BoxPair<double>& q);
ExactPair exact_pair(const TurnedPair<double>& q);
ExactPair exact_pair(const CornersPair<double>& q);
ExactPair exact_pair(const MixedPair<double>& q);

// A box and a triangle over the rationals, and how deep they are in contact.

using ExactBoxAndTriangle = BoxAndTriangle<Rational>;

// Precondition as of two boxes.
ExactBoxAndTriangle exact_box_and_triangle(const CentredAndTriangle<double>& q);
ExactBoxAndTriangle exact_box_and_triangle(const CornersAndTriangle<double>& q);
ExactBoxAndTriangle exact_box_and_triangle(const BoxAndTriangle<double>& q);
ExactBoxAndTriangle exact_box_and_triangle(const TurnedAndTriangle<double>& q);

Hull hull_of(const std::array<Point, 3>& corners);

// An axis that is not 0, as the direction in which the second body comes to leave the first; `either_way`: so does its
// opposite. `rest` is what is left of the extents beside the distance, times the axis' length: negative where it parts
// them. `back` is the same of the opposite direction, and no less.
struct AxisRest {
  std::size_t index;
  Point along;
  bool either_way;
  Rational rest, back, squared_length;
  Rational squared() const { return rest * rest / squared_length; }
};
std::vector<AxisRest> axis_rests(const ExactPair& q);
std::vector<AxisRest> axis_rests(const ExactBoxAndTriangle& q);
// Those of the axes that decide: on which the penetration is least, or which part the bodies.
std::vector<AxisRest> deciding(std::vector<AxisRest> axes);

// As of two boxes, below; the penetration is the least over the thirteen axes that are not 0.
Rational squared_penetration(const ExactBoxAndTriangle& q);
std::vector<std::string_view> deciding_axes(const ExactBoxAndTriangle& q);
Rational squared_distance(const ExactBoxAndTriangle& q);
Rational squared_scene(const ExactBoxAndTriangle& q);
ExactDepth exact_depth(const ExactBoxAndTriangle& q);

// How deep two boxes are in contact, or how far apart: squares of lengths, exactly.

// The square of the penetration of boxes in contact: the least translation of one that parts them, or makes them touch.
// It is the least of (radius - |T.L|) / |L| over the fifteen axes that are not 0, which are normals of all facets of
// A - B.
Rational squared_penetration(const ExactPair& q);

// The square of the greatest gap between the projections of boxes apart on one of the fifteen axes, as a length: at
// most their distance.
Rational squared_gap(const ExactPair& q);

// The axes that decide: of boxes in contact those on which the penetration is least, else those that separate.
std::vector<std::string_view> deciding_axes(const ExactPair& q);

// The greatest f for which boxes are in contact with B's centre at A's + f u, u not 0: rational.
Rational critical_factor(const ExactPair& q, const Point& u);

// The least half extent of A's first axis for which the boxes are in contact, all else as it is; q.a.half[0] is not
// read. It is rational: the greatest of (|T.L| - the other five terms) / |a0.L| over the fifteen axes that a0 is not at
// right angles to, and not below 0. Empty where an axis at right angles to a0 separates: then no extent along it is
// enough.
std::optional<Rational> critical_extent(const ExactPair& q);

// The square of their distance; 0 in contact.
Rational squared_distance(const ExactPair& q);

// The greatest entry of B'B - I in magnitude, B the matrix of the box's axes: 0 of a rotation alone.
Rational orthonormality_defect(const ExactBox& box);

// The square of the scene's extent: the greatest of |T|, from centre to centre, and of the distances of the corners
// from the centre of their own box.
Rational squared_scene(const ExactPair& q);

// Penetration or distance relative to the scene; 0 for two points in the same place.
ExactDepth exact_depth(const ExactPair& q);

// Lengths, places and directions that exact arithmetic tells besides the verdict.

// The query is valid. The normal is the direction in which B leaves A, or the triangle the box.
std::vector<ExactFact> exact_facts(const ExactPair& q);
std::vector<ExactFact> exact_facts(const ExactBoxAndTriangle& q);

}  // namespace axiscert::boxes
