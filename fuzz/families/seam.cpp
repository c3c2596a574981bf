// Centres solved onto each of the nine side boundaries, which are the seams between the regions of two features.
//
// On a seam the distances to both features are equal, so either axis separates and a wrong side is masked by the other
// feature's radius comparison; unless the radius is within rounding of the distance, where both can go wrong at once.
// Hence half of the radii are there.
#include <algorithm>
#include <cmath>

#include "fuzz/boundary.h"
#include "fuzz/families/shapes.h"
#include "fuzz/family.h"

namespace axiscert {
namespace {

struct Seam {
  Comparison side;
  bool at_vertex;  // between the regions of vertex `from` and of the edge towards `to`; else of edge `from` and face
  std::size_t from, to;
  // The edge whose outward direction lies in the seam's region: at a vertex, the edge that joins the two vertices.
  std::size_t edge() const { return at_vertex && shapes::next(to) == from ? to : from; }
};
constexpr std::array<Seam, 9> seams = {{
    {Comparison::vertex_a_side_b, true, 0, 1},
    {Comparison::vertex_a_side_c, true, 0, 2},
    {Comparison::vertex_b_side_a, true, 1, 0},
    {Comparison::vertex_b_side_c, true, 1, 2},
    {Comparison::vertex_c_side_a, true, 2, 0},
    {Comparison::vertex_c_side_b, true, 2, 1},
    {Comparison::edge_ab_side_c, false, 0, 2},
    {Comparison::edge_bc_side_a, false, 1, 0},
    {Comparison::edge_ca_side_b, false, 2, 1},
}};

// One of the coordinates in which the gradient is at least half as large as in its largest.
template <class Real>
int effective_coordinate(Stream& random, const Vec3<Real>& gradient) {
  const std::array<Real, 3> effect = {std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)};
  const Real least = std::max({effect[0], effect[1], effect[2]}) / 2;
  std::array<int, 3> eligible{};
  std::size_t count = 0;
  for (int k = 0; k < 3; ++k) {
    if (effect[static_cast<std::size_t>(k)] >= least) eligible[count++] = k;
  }
  return eligible[random.below(count)];
}

template <class Real>
Query<Real> seam(Stream& random, std::uint64_t position) {
  const Seam& which = seams[position % 9];
  const bool radius_at_boundary = position / 9 % 2 == 0;
  const int ulps = static_cast<int>(position / 18 % 9) - 4;

  const auto vertices = shapes::vertices_in_cube<Real>(random);
  const auto [normal, outward] = shapes::directions(vertices);
  Vec3<Real> foot = vertices[which.from], direction = normal * random.symmetric<Real>();
  if (which.at_vertex) direction = direction + outward[which.edge()] * (random.unit<Real>() + Real(0x1p-5));
  else foot = shapes::inside_edge(random, vertices, which.from);
  Query<Real> q = shapes::query(vertices, foot + shapes::at_unit_length(direction) * shapes::height<Real>(random));

  const Vec3<Real> gradient = which.at_vertex ? vertices[which.to] - vertices[which.from] : outward[which.from];
  const int coordinate = effective_coordinate(random, gradient);
  Real& x = coordinate == 0 ? q.p.x : coordinate == 1 ? q.p.y : q.p.z;
  x = step_ulps(coordinate_on_boundary(q, which.side, coordinate), ulps);
  q.r = radius_at_boundary ? shapes::radius_near_distance(random, q, 2) : random.unit<Real>() * 2;
  return q;
}

}  // namespace

extern const Family seam_family = {
    "seam",
    "centre on the boundary of each side comparison in turn, -4 to +4 ulp, half of the radii at the distance",
    1,
    false,
    seam<float>,
    seam<double>};

}  // namespace axiscert
