// The levels of --require, and where a record falls short of one.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {

enum class RequirementLevel { logic, range, exact, conservative };

struct Requirement {
  RequirementLevel level;
  double deepest = std::numeric_limits<double>::infinity();  // conservative: the deepest phantom contact allowed

  std::string sentence() const;  // states the requirement, for a report
};

// Parses "logic", "range", "exact", "conservative" or "conservative=D". Throws Error that lists them.
Requirement parse_requirement(const std::string& text);

// One way in which a kernel falls short.
struct Failure {
  std::string kernel, precision, family;  // precision and family are empty for a kernel that could not be loaded
  std::uint64_t count;                    // number of wrong verdicts, or of the cases that `what` names
  std::string what;                       // for example "missed contacts"
  std::string witness;                    // the deepest one that shows it; empty where none was stored

  bool is_of(const Json& kernel) const;  // whether it is about this entry of the record's "kernels"
  std::string text() const;
};

// The failures of a record at a level; empty where it meets the level. A kernel with a finding, or with a query within
// its limits that it did not answer, meets no level; queries outside the limits do not count at any. Throws Error as
// parse_requirement does.
std::vector<Failure> unmet(const Json& record, const std::string& level);

}  // namespace axiscert
