// JSON text from a file to a value that may be written, compared and searched without a thought of its depth.
#pragma once

#include <string_view>

#include "fuzz/text/json.h"

namespace axiscert {

// What axiscert writes is some ten levels deep. nlohmann's functions on a value call themselves once a level, so that a
// file of brackets would take the stack.
inline constexpr int greatest_json_depth = 100;

// Throws Json::exception where the text is no JSON, or deeper than that.
Json parsed_json(std::string_view text);

}  // namespace axiscert
