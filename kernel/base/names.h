// The names there are, in a message about one that there is not, and the name that was meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

// Sorted by likeness to a given one. The measure is edit distance, where upper and lower case are one; names at equal
// distance keep their order.
std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names);

// The name that `given` may have been meant for: it differs in its case, begins so, or has few other letters. Empty
// where no name is so near.
std::string_view meant(std::string_view given, const std::vector<std::string_view>& names);

// "; did you mean 'NAME'?", or ";" where no name is so near: a message goes on with a space.
std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& names);

// "unknown family 'GIVEN'; did you mean 'NAME'? families: NAME, ...", the most alike first: of the kind `family`, of
// the kinds `families`. A list with commas is told that one name is given at a time.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names);

// "families: NAME, ...", the most alike first; of more than eight "the nearest of 97 families: NAME, ...; `COMMAND`
// lists them".
std::string names_alike(std::string_view kinds, std::string_view given, const std::vector<std::string_view>& names,
                        std::string_view command);

// The same of names that a command lists.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names, std::string_view command);

}  // namespace axiscert
