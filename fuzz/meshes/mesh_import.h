// The triangles of a mesh file, as read by assimp.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/geometry.h"

namespace axiscert {

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

}  // namespace axiscert
