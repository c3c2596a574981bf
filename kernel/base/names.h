// The names there are, in a message about one that there is not; text.h has what is alike.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

// "families: NAME, ...", the most alike first; of more than eight "the nearest of 97 families: NAME, ...; `COMMAND`
// lists them".
std::string names_alike(std::string_view kinds, std::string_view given, const std::vector<std::string_view>& names,
                        std::string_view command);

// unknown_name() of text.h, of names that a command lists.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names, std::string_view command);

}  // namespace axiscert
