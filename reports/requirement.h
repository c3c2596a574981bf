// What --require asks of a run, and where a record falls short of it.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "reports/json.h"

namespace axiscert {

enum class RequirementLevel { logic, range, exact, conservative };

struct Requirement {
  RequirementLevel level;
  double deepest = std::numeric_limits<double>::infinity();  // conservative: the deepest phantom contact allowed

  std::string sentence() const;  // what it asks, for a report
};

// "logic", "range", "exact", "conservative" or "conservative=D". Throws Error that lists them.
Requirement parse_requirement(const std::string& text);

// One family of one kernel that falls short.
struct Failure {
  std::string kernel, precision, family;
  std::uint64_t count;  // of wrong verdicts
  std::string what;     // "missed contacts"
  std::string witness;  // the deepest one that shows it; empty where none was stored

  bool is_of(const Json& kernel) const;  // an entry of the record's "kernels"
  std::string text() const;
};

// Empty where the record meets the level. Throws Error as parse_requirement does.
std::vector<Failure> unmet(const Json& record, const std::string& level);

}  // namespace axiscert
