// A mesh as a source: the queries that a physics engine makes for a real mesh's triangles.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/random.h"
#include "kernel/base/geometry.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// The triangles of a mesh file, as read by assimp.

using portable::Vec3;
using MeshTriangle = std::array<Vec3<float>, 3>;

struct ImportedMesh {
  std::vector<MeshTriangle> triangles;  // finite; in the order of the file's meshes and faces
  // Faces that give no triangle: points, lines, and triangles with a vertex that is not finite.
  std::uint64_t skipped_primitives = 0;
};

// The resources that assimp may use for one file, beyond those the caller uses already: far more than any mesh of that
// size needs.
struct ImportLimits {
  std::uint64_t bytes;    // address space
  std::uint64_t seconds;  // processor time
};
constexpr ImportLimits limits_for(std::uint64_t file_size) {
  return {(std::uint64_t{4} << 30) + 256 * file_size, 10 + (file_size >> 20)};
}

// Imports every mesh of the scene in its own coordinates (no node transformations), polygons triangulated, vertices not
// joined and degenerate triangles not removed. The installed assimp determines which triangles a file contains.
//
// assimp runs in a separate process: on a malformed file it may abort, request hundreds of gigabytes, print or never
// end, and none of that may affect the caller. Throws Error with the path and assimp's own reason, or with the way in
// which it ended. Call it before starting threads.
ImportedMesh import_mesh(const std::string& path, const ImportLimits& limits);

// Immutable once loaded.
struct Mesh {
  std::vector<MeshTriangle> triangles;     // at least one; degenerate ones are kept
  std::uint64_t degenerate_triangles = 0;  // zero area, exactly, with the file's binary32 coordinates
  std::uint64_t skipped_primitives = 0;    // points, lines, and triangles with a vertex that is not finite
  double diagonal = 0;                     // diagonal of the bounding box
};

// The version of the spheres placed about the triangles, which name the streams of all that builds on them.
inline constexpr int placements_version = 2;

// Throws Error with the path if the file cannot be read, is not a mesh according to assimp, or contains no triangle.
Mesh load_mesh(const std::string& path, std::uint64_t file_size);

// The queries that a predicate has for a mesh: a capability of the predicate (fuzz/queries/capabilities.h).
struct MeshQueries {
  std::string_view purpose;  // one line
  int version;               // raised with what is made at a position
  std::size_t entry;
  // From position `first` on. `placed` names the stream of the spheres about the triangles (placements_version), on
  // which every predicate builds; `own` that of what the predicate adds to them. Every number is finite.
  void (*in_binary32)(const Mesh& mesh, const StreamName& placed, const StreamName& own, std::uint64_t first,
                      const MutableColumns<float>& out);
  void (*in_binary64)(const Mesh& mesh, const StreamName& placed, const StreamName& own, std::uint64_t first,
                      const MutableColumns<double>& out);
};
// The predicate is one of mesh_predicates().
const MeshQueries& mesh_queries_of(const Predicate& predicate);

}  // namespace axiscert
