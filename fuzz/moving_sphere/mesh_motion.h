// Motions past the triangles of a mesh.
#pragma once

#include "fuzz/files/mesh.h"

namespace axiscert {

// Motions of the sphere, for the moving sphere's queries: each placement belongs to one, and every other round of the
// placements is a shaking camera's, but for the bullets.
enum class MeshMotion : std::uint8_t {
  walking,   // resting, sinking, hovering: along the face, a step of a character; every other time of radius 0.3
  dropped,   // edge_graze, vertex_graze: a ball that falls on the edge or vertex, to where it rests or beyond
  bullet,    // centre_on: tiny, and far in one step, through the vertex, the edge or the face
  arriving,  // far: from out of reach to a point of the face, and back again as far or less
  shaking,   // tiny motions in any direction, from where the placement is
};
MeshMotion mesh_motion_at(std::uint64_t position, std::uint64_t triangles);

// The moving sphere's queries, of sixteen columns: at each position the triangle and sphere that fill_mesh_queries()
// places there, at the start of a motion, at its end or on its way. `placed` names the stream of the placements,
// `moved` that of the motions. Every number is finite.
template <class Real>
void fill_mesh_motions(const Mesh& mesh, const StreamName& placed, const StreamName& moved, std::uint64_t first,
                       const MutableColumns<Real>& out);

extern const MeshQueries moving_sphere_mesh;

}  // namespace axiscert
