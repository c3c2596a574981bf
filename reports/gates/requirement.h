// What --require asks of a run, and where a record falls short of it.
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

  std::string sentence() const;  // what it asks, for a report
};

// "logic", "range", "exact", "conservative" or "conservative=D". Throws Error that lists them.
Requirement parse_requirement(const std::string& text);

// Where one kernel falls short.
struct Failure {
  std::string kernel, precision, family;  // precision and family are empty for a kernel that could not be loaded
  std::uint64_t count;                    // of wrong verdicts, or of what `what` names
  std::string what;                       // "missed contacts"
  std::string witness;                    // the deepest one that shows it; empty where none was stored

  bool is_of(const Json& kernel) const;  // an entry of the record's "kernels"
  std::string text() const;
};

// Empty where the record meets the level. No level is met by a kernel with a finding, or with a query within its limits
// that it did not answer; none reads what happens outside these. Throws Error as parse_requirement does.
std::vector<Failure> unmet(const Json& record, const std::string& level);

}  // namespace axiscert
