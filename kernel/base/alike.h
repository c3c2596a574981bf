// Names sorted by likeness to a given one, for a message that says what would have been right.
#pragma once

#include <string_view>
#include <vector>

namespace axiscert {

// The measure is edit distance; names at equal distance keep their order.
std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names);

}  // namespace axiscert
