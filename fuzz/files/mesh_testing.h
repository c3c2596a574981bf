// Meshes for tests: the models of assimp's package, and files that a test writes.
#pragma once

#include <string>

#include "kernel/base/folders.h"

namespace axiscert {

inline std::string model(const std::string& path) { return std::string(TEST_MODELS) + "/" + path; }

// A mesh file written by the test, in a folder of its own.
struct OwnMesh {
  TemporaryFolder folder;
  std::string path;
  OwnMesh(const std::string& name, const std::string& text) : path(folder.write(name, text)) {}
};

// One triangle with area, a needle whose vertices are collinear, one point three times; then a line.
inline const std::string degenerate_obj =
    "v 0 0 0\nv 3 0 0\nv 0 2 1\nv 1 1 1\nv 2 2 2\nf 1 2 3\nf 1 4 5\nf 2 2 2\nl 1 2\n";

}  // namespace axiscert
