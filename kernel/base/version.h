// What this axiscert is. One object has each, so that a new version or commit compiles nothing else again.
#pragma once

namespace axiscert {

// As project() in CMakeLists.txt has it, such as "0.2.0".
extern const char* const axiscert_version;

// The commit that it was built from, with "-dirty" where the tree differed from it; "unknown" without a repository
// (cmake/revision.cmake).
extern const char* const axiscert_revision;

}  // namespace axiscert
