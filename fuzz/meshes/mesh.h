// A mesh as a source: the queries that a physics engine makes for a real mesh's triangles.
#pragma once

#include <optional>
#include <string>

#include "fuzz/meshes/mesh_import.h"
#include "fuzz/queries/random.h"
#include "kernel/test.h"

namespace axiscert {

// Immutable once loaded.
struct Mesh {
  std::vector<MeshTriangle> triangles;     // at least one; degenerate ones are kept
  std::uint64_t degenerate_triangles = 0;  // zero area, exactly, with the file's binary32 coordinates
  std::uint64_t skipped_primitives = 0;    // points, lines, and triangles with a vertex that is not finite
  double diagonal = 0;                     // diagonal of the bounding box
};

// Throws Error with the path if the file cannot be read, is not a mesh according to assimp, or contains no triangle.
Mesh load_mesh(const std::string& path, std::uint64_t file_size);

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
void mesh_queries(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out);

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

// The moving sphere's queries, of sixteen columns: at each position the triangle and sphere that mesh_queries() places
// there, at the start of a motion, at its end or on its way. `placed` names the stream of the placements, `moved` that
// of the motions. Every number is finite.
template <class Real>
void mesh_motions(const Mesh& mesh, const StreamName& placed, const StreamName& moved, std::uint64_t first,
                  const MutableColumns<Real>& out);

// Queries of a box and a triangle by two corners (entry `minmax`): at each position the triangle that mesh_queries()
// has there, and the cell of a grid in which a point of it is, or one beside that; `cells` names the stream of the
// cells. Their sides are powers of two, a quarter to eight times the triangle's longest side along an axis. Every
// number is finite.
template <class Real>
void mesh_voxels(const Mesh& mesh, const StreamName& placed, const StreamName& cells, std::uint64_t first,
                 const MutableColumns<Real>& out);

// The entry in which a mesh has queries of a test of mesh_tests().
std::size_t mesh_entry(const TestDescription& test);

}  // namespace axiscert
