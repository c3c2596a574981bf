// The version of axiscert, as project() in CMakeLists.txt has it, such as "0.2.0". One object has it, so that a new
// version compiles nothing else again.
#pragma once

namespace axiscert {

extern const char* const axiscert_version;

}  // namespace axiscert
