// What this axiscert is: version, revision, and whether AddressSanitizer instruments it.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define AXISCERT_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define AXISCERT_ADDRESS_SANITIZER
#endif
#endif

namespace axiscert {

// As project() in CMakeLists.txt has it, such as "0.2.0".
extern const char* const axiscert_version;

// The commit that it was built from, with "-dirty" where the tree differed from it; "unknown" without a repository
// (cmake/revision.cmake).
extern const char* const axiscert_revision;

}  // namespace axiscert
