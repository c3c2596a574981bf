// The place of the triangle that is nearest to the centre, exactly.
#pragma once

#include <string_view>
#include <vector>

#include "exact/judge/exact_facts.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

struct NearestPlace {
  // All parts that have the point: at least one. A part is without its rim: where a vertex is nearest, its edges are
  // not.
  std::vector<std::string_view> features;
  Vec3<Rational> point;
  Rational squared_distance;
};

// The numbers are finite; r is not read. Distances to vertices and edges are compared with CGAL's to the triangle.
// Throws OracleDisagreement.
NearestPlace nearest_place(const Query<double>& q);

// The query is valid.
std::vector<ExactFact> exact_facts(const Query<double>& q);

}  // namespace axiscert
