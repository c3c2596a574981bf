// A box and a triangle over the rationals, and how deep they are in contact.
#pragma once

#include "exact/boxes/exact_box.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {

using ExactBoxAndTriangle = BoxAndTriangle<Rational>;

// Precondition: the numbers are finite. The centre and half extents of two corners are exact.
ExactBoxAndTriangle exact_box_and_triangle(const CentredAndTriangle<double>& q);
ExactBoxAndTriangle exact_box_and_triangle(const CornersAndTriangle<double>& q);
ExactBoxAndTriangle exact_box_and_triangle(const BoxAndTriangle<double>& q);

Hull hull_of(const std::array<Point, 3>& corners);

// As of two boxes (exact/boxes/box_measures.h); the penetration is the least over the thirteen axes that are not 0.
Rational squared_penetration(const ExactBoxAndTriangle& q);
std::vector<std::string_view> deciding_axes(const ExactBoxAndTriangle& q);
Rational squared_distance(const ExactBoxAndTriangle& q);
double depth_of(const ExactBoxAndTriangle& q);

}  // namespace axiscert::boxes
