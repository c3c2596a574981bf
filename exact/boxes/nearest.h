// The nearest points of two convex hulls, exactly, with a certificate that proves them.
#pragma once

#include <string>
#include <vector>

#include "exact/numbers/binary_number.h"
#include "exact/numbers/rational.h"
#include "kernel/base/geometry.h"

namespace axiscert::boxes {

using Point = portable::Vec3<Rational>;
// The convex hull of these points: at least one; repeated points and hulls without volume are allowed.
using Hull = std::vector<Point>;

// The same of points whose coordinates have finitely many binary digits.
using BinaryPoint = portable::Vec3<BinaryNumber>;
using BinaryHull = std::vector<BinaryPoint>;

// A point of each hull as a convex combination of its vertices, and the vector `apart` from that of B to that of A,
// which is 0 where the hulls have a point in common. All are times `total`, which is positive, so that none is a
// quotient.
struct NearestPoints {
  std::vector<BinaryNumber> weights_a, weights_b;  // one a vertex
  BinaryNumber total;
  BinaryPoint apart;
  bool in_contact() const { return apart.x.sign() == 0 && apart.y.sign() == 0 && apart.z.sign() == 0; }
};

// The pair of least distance; for hulls in contact, a point in both.
//
// Exact, without a division: from a simplex of differences of vertices to the next one that comes nearer to 0, as in
// Wolfe's and Gilbert's methods. Each simplex has its own nearest point, and the distance falls with each, so none
// returns and the loop ends; no step has a tolerance. The result is checked by refutation_text().
// Throws HarnessFault if the check fails.
// Source: P. Wolfe, Finding the nearest point in a polytope, Mathematical Programming 11 (1976).
NearestPoints nearest_points(const BinaryHull& a, const BinaryHull& b);

// The reason for which this does not prove the hulls' distance to be |apart| / total, or empty. It does where the
// weights are not negative and those of a hull sum to `total`, the two points differ by `apart`, and all of A is beyond
// A's point along `apart`, all of B before B's: then no pair of points is nearer. It does not depend on how the points
// were found.
std::string refutation_text(const NearestPoints& found, const BinaryHull& a, const BinaryHull& b);

// The square of the hulls' distance, by their nearest points; and these points.
Rational squared_distance(const Hull& a, const Hull& b);
struct NearestPair {
  Point a, b;
};
NearestPair nearest_pair(const Hull& a, const Hull& b);

// Whether no other pair is as near, of the nearest points of hulls apart, with the normal a - b, or of one point of
// hulls that touch, with the normal of a plane that has one hull on each side.
bool is_only_pair(const NearestPair& nearest, const Point& normal, const Hull& a, const Hull& b);

}  // namespace axiscert::boxes
