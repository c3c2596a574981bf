// A level of --require: its name, its sentence, and how one kernel in one precision is judged by it. A new one
// is a file that defines a GateLevel, and a line in levels.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/gates/levels/subject.h"

namespace axiscert {

// A level as it was asked for. "depth=0.01" is the level `depth` with the argument "0.01".
struct AskedLevel {
  std::string text;           // whole
  std::string name;           // before the first '='
  std::string argument = {};  // after it; empty where there is none
  bool has_argument = false;

  static constexpr auto fields(auto&& visit) {
    using Of = AskedLevel;
    return visit(field(&Of::text, {"level", "The level as it was given."}), journalled(&Of::name),
                 journalled(&Of::argument), journalled(&Of::has_argument));
  }
};

// The findings of a level about one kernel in one precision. It is met where there is no failure, `not_checked` is
// empty, and enough of each family was looked at (reports/gates/requirement.cpp).
struct LevelFindings {
  std::vector<Failure> failures;
  std::string not_checked;                     // why these queries cannot show that it is met; empty where they can
  std::map<std::string, FamilyLook> families;  // those that the level requires, by name
  std::string covers, leaves_out;   // what "met" says of this kernel and what it does not, without a full stop
  std::vector<std::string> unseen;  // families on which this kernel cannot be seen to fail the level
};

struct GateLevel {
  const char* usage;    // "conservative[=D]": the name, then how an argument is given where it takes one
  const char* meaning;  // one line for lists and --help
  // Checks the argument, which is there only where `usage` has one. Throws Error that says what would be right.
  void (*check)(const AskedLevel&);
  // States the requirement, for a report: "no missed contact".
  std::string (*sentence)(const AskedLevel&);
  LevelFindings (*judge)(const AskedLevel&, const Subject&);
  // The kernel that others are measured against, which itself has to meet no level; null where there is none.
  std::string (*yardstick)(const AskedLevel&) = nullptr;

  std::string_view name() const;
};

// In the order in which they are listed.
std::span<const GateLevel* const> gate_levels();

// For levels that take a depth: the argument as a share of the scene. Throws Error that names the level.
double depth_argument(const AskedLevel& asked);
// That of `decided=SHARE`. Throws Error that says what would be right.
double decided_argument(const AskedLevel& asked);
void no_argument(const AskedLevel& asked);  // for levels that take none: the parser has refused it already

}  // namespace axiscert
