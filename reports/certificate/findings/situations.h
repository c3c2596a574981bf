// The situations (fuzz/queries/situation.h) in which a kernel is wrong.
#pragma once

#include <string>

#include "fuzz/record/record.h"

namespace axiscert {

// A depth, relative to the scene, from which on roundings near touching are not to blame.
inline constexpr double visible_depth = 0.001;

// The situations in which a kernel is wrong, an entry for each precision: precision, situation, meaning, families
// (those with a wrong verdict, the deepest first), missed, deepest_missed, phantom, deepest_phantom, advice, section.
// The most everyday ones first, queries of no family last. Depths are numbers here.
Json situations_json(const Record& record, const std::string& kernel);

// The entry of these that breaks first: the most everyday one with missed contacts of a visible depth, else with such
// phantoms, else that with the deepest missed contact, or phantom. Null where there is none. `missed` says which it is.
const Json* first_situation(const Json& situations, bool& missed);

}  // namespace axiscert
