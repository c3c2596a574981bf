// Situations: what the family of a query says of a wrong answer, where nothing but the verdict is seen.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/record/record.h"

namespace axiscert {

struct Situation {
  std::string_view name;      // stable, for files: "parallel"
  std::string_view meaning;   // of its queries: "motions parallel to the face or to an edge"
  std::string_view advice;    // to whoever has to use the kernel, a sentence
  std::string_view section;   // of the documents
  std::string_view families;  // their names without the test's id, separated by blanks
};

// A depth, relative to the scene, from which on roundings near touching are not to blame.
inline constexpr double visible_depth = 0.001;

// The situations in which a kernel is wrong, an entry for each precision: precision, situation, meaning, families
// (those with a wrong verdict, the deepest first), missed, deepest_missed, phantom, deepest_phantom, advice, section.
// In the order of TestWords::situations. Depths are numbers here.
Json situations_json(const Record& record, const std::string& kernel);

// The entry of these that breaks first: the most everyday one with missed contacts of a visible depth, else with such
// phantoms, else that with the deepest missed contact, or phantom. Null where there is none. `missed` says which it is.
const Json* first_situation(const Json& situations, bool& missed);

}  // namespace axiscert
