// Spheres placed about the triangles of a mesh.
#pragma once

#include "fuzz/files/mesh.h"

namespace axiscert {

// Positions of the sphere. "Beside": P lies where that edge or vertex is the nearest feature of the triangle.
enum class Placement : std::uint8_t {
  resting,       // above a point of the face, r the float nearest to the exact distance, up to 4 ulps from it
  sinking,       // the same, r 0.1 to 50 % greater than the distance
  hovering,      // the same, r 0.1 to 50 % smaller
  edge_graze,    // beside an edge, r within 4 ulps of the distance
  vertex_graze,  // beside a vertex, r within 4 ulps of the distance
  centre_on,     // P on a vertex, an edge or the face (up to P's own rounding), r tiny or zero
  far,           // out of reach, by up to 2^10 radii
};
inline constexpr std::uint64_t placement_count = 7;

// Triangle `position % triangles`; placements take turns over the triangles and again over the rounds: `triangles`
// consecutive positions include every triangle once and every placement, and 7 `triangles` of them include every pair.
constexpr Placement placement_at(std::uint64_t position, std::uint64_t triangles) {
  return static_cast<Placement>((position % triangles + position / triangles) % placement_count);
}

// Distances and radii (except for the last two placements) are 2^-6 to 2^6 mean edges; if a triangle is a single point,
// the diagonal of the mesh's box replaces the edge, or 1 if that is zero too. binary32: the file's own vertices.
// binary64: the mesh rotated by an integer quaternion and scaled by 2^-4 to 2^5, drawn anew for each position and
// computed in binary64; the rounded vertices are the query's. Every number is finite.
template <class Real>
void fill_mesh_queries(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out);

extern const MeshQueries sphere_triangle_mesh;

}  // namespace axiscert
