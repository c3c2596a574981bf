// The directions that decide whether two convex hulls of any points meet: boxes, polyhedra, polygons, segments, points.
#pragma once

#include "exact/boxes/nearest.h"

namespace axiscert::boxes {

// Which directions of flat hulls are asked besides their normals and products.
enum class InPlane { asked, left_out };

// Axes such that two hulls without a common point are apart on one of them. Over the reals:
// - where the edges of both together span the space: the normals of facets, and the products of an edge of each;
// - where they span a plane, as those of two polygons in parallel planes do: its normal, and in it one at right angles
// to
//   each edge. Without the latter (`left_out`) polygons of one plane are never told apart;
// - where they span a line: it, and the part of the vector between the hulls that is at right angles to it;
// - where both are points: the vector between them.
// None is 0; several may be parallel. A hull's edges and facets are found by trying all pairs and triples of its
// points, in exact arithmetic: n^4 steps for n points. Neither hull is empty.
std::vector<Point> separating_axes(const Hull& a, const Hull& b, InPlane in_plane = InPlane::asked);

// Whether the hulls' projections on one of these axes have no number in common.
bool are_apart_on(const std::vector<Point>& axes, const Hull& a, const Hull& b);

}  // namespace axiscert::boxes
