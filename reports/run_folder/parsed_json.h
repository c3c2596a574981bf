// Reads JSON text from a file into a value that is safe to write, compare and search recursively.
#pragma once

#include <string_view>

#include "fuzz/text/json.h"

namespace axiscert {

// The files that axiscert writes are some ten levels deep. nlohmann's functions on a value recurse once for each level,
// so that a file of brackets would exhaust the stack.
inline constexpr int greatest_json_depth = 100;

// Throws Json::exception where the text is not JSON, or is deeper than that.
Json parsed_json(std::string_view text);

}  // namespace axiscert
