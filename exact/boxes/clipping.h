// A second way to the truth about two boxes: the edges of each, clipped by the other. It shares nothing with the
// nearest points or with the fifteen axes but the query's numbers.
#pragma once

#include <CGAL/Mpzf.h>

#include <utility>

#include "kernel/boxes/thirteen.h"

namespace axiscert {
// A number of finitely many binary digits by CGAL, as a number type of the formulae (kernel/formulae_kernel.h): what
// finite floats become by +, - and *. exact/numbers/binary_number.h is another one for the same purpose, in which the
// formulae are evaluated: what is computed in one of them checks what is computed in the other.

struct DyadicNumber {
  CGAL::Mpzf value;

  DyadicNumber() = default;
  explicit DyadicNumber(double x) : value(x) {}  // finite
  explicit DyadicNumber(CGAL::Mpzf x) : value(std::move(x)) {}

  friend DyadicNumber operator+(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value + b.value);
  }
  friend DyadicNumber operator-(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value - b.value);
  }
  friend DyadicNumber operator*(const DyadicNumber& a, const DyadicNumber& b) {
    return DyadicNumber(a.value * b.value);
  }
  friend DyadicNumber magnitude(const DyadicNumber& a) {
    return DyadicNumber(a.value.sign() == CGAL::NEGATIVE ? -a.value : a.value);
  }
  friend bool operator>(const DyadicNumber& a, const DyadicNumber& b) { return a.value > b.value; }
  friend bool operator>=(const DyadicNumber& a, const DyadicNumber& b) { return !(a.value < b.value); }
};

}  // namespace axiscert

namespace axiscert::boxes {
struct Common {
  bool meets;           // the boxes have a point in common
  bool interiors_meet;  // and no small translation parts them
};

// Each box is an intersection of three slabs, so a corner of what they have in common is where three independent planes
// of facets meet: on an edge of A, within B, or on an edge of B, within A. Hence the boxes meet exactly where a part of
// one of the 24 edges is in all three slabs of the other, and what they have in common is the hull of the ends of these
// parts. It is Gottschalk's test of 144 edges and faces (1995), with an edge inside a box counted too.
//
// No small translation parts them where the point 0 is inside A - B, not on its boundary: where a point is in the
// relative interior of both and their edges together span the space. The mean of those ends is such a point if any is.
// It is off a bounding plane exactly where one of them is, since none is beyond it.
//
// No number is divided: a place on an edge is kept as a quotient.
//
// Precondition: the axes of each box are independent; half extents may be 0.
Common common_of(const BoxPair<DyadicNumber>& q);

// The same of a box and a triangle, which may be degenerate. A corner of what they have in common is on an edge of the
// triangle, within the box, or on an edge of the box, within the triangle.
Common common_of(const BoxAndTriangle<DyadicNumber>& q);

}  // namespace axiscert::boxes
