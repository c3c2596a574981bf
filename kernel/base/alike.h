// Names in the order of how alike they are to one that was given, for a message that says what would have been right.
#pragma once

#include <string_view>
#include <vector>

namespace axiscert {

// By how many letters have to be put in, taken out or changed; those that need as many stay in their order.
std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names);

}  // namespace axiscert
