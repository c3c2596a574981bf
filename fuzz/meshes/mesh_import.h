// The triangles of a mesh file, as assimp reads them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/query.h"

namespace axiscert {

using MeshTriangle = std::array<Vec3<float>, 3>;

struct ImportedMesh {
  std::vector<MeshTriangle> triangles;  // finite; in the order of the file's meshes and faces
  // Faces that give no triangle: points, lines, and triangles with a vertex that is not finite.
  std::uint64_t skipped_primitives = 0;
};

// What assimp may use for one file, beyond what the caller uses already: far more than any mesh of that size needs.
struct ImportLimits {
  std::uint64_t bytes;    // of address space
  std::uint64_t seconds;  // of processor time
};
constexpr ImportLimits limits_for(std::uint64_t file_size) {
  return {(std::uint64_t{4} << 30) + 256 * file_size, 10 + (file_size >> 20)};
}

// Every mesh of the scene in its own coordinates (no node transformations), polygons triangulated, vertices not joined
// and degenerate triangles not removed. Which triangles a file holds is for the installed assimp to say.
//
// assimp runs in a process of its own: on a malformed file it may abort, ask for hundreds of gigabytes, print or never
// end, and none of that may reach the caller. Throws Error with the path and assimp's own reason, or with how it ended.
// Call it before starting threads.
ImportedMesh import_mesh(const std::string& path, const ImportLimits& limits);

}  // namespace axiscert
