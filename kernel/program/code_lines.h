// Lines of code in any language with places for the numbers of a query, by which a manifest says how its engine is
// asked one query by hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "kernel/predicate.h"

namespace axiscert::plugin {

// The places that code for queries of this entry may have: "ax" for a column, and "a" for the columns of a group, with
// commas between them.
std::vector<std::string> places_of(const PredicateEntry& entry);

// The first place of a line, without its braces, that is not among `known`; empty where there is none. A place is small
// letters alone between braces, as {ax}: braces of the language itself have anything else, or a space, beside them.
std::string unknown_place(std::string_view line, const std::vector<std::string>& known);

// The lines, one below the other, with the numbers in their places; `numbers` has one text for each column of the
// entry. A place that the entry does not have stays as it is.
std::string filled_code(const std::vector<std::string>& lines, const PredicateEntry& entry,
                        const std::vector<std::string>& numbers);

}  // namespace axiscert::plugin
