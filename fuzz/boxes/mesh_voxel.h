// The cells of a grid about the triangles of a mesh.
#pragma once

#include "fuzz/meshes/mesh.h"

namespace axiscert {

// Queries of a box and a triangle by two corners (entry `minmax`): at each position the triangle that
// fill_mesh_queries() has there, and the cell of a grid in which a point of it is, or one beside that; `cells` names
// the stream of the cells. Their sides are powers of two, a quarter to eight times the triangle's longest side along an
// axis. Every number is finite.
template <class Real>
void fill_mesh_voxels(const Mesh& mesh, const StreamName& placed, const StreamName& cells, std::uint64_t first,
                      const MutableColumns<Real>& out);

extern const MeshQueries box_triangle_mesh;

}  // namespace axiscert
