// A level of --require: its name, its sentence, and how one kernel in one precision is judged by it. A new one
// is a file that defines a GateLevel, and a line in levels.cpp.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
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

// The deepest wrong verdicts that are allowed, as shares of the scene; below 0: none.
struct AllowedDepths {
  double missed, phantom;
};
inline constexpr double no_wrong = -1, any_depth = std::numeric_limits<double>::infinity();

// A certificate's badge names the level of the lowest rank that is met, in its colour.
struct Badge {
  int rank;
  const char* colour;
};

inline constexpr std::string_view no_arguments[] = {""}, visible_depths[] = {"0.001"},
                                  no_or_visible_depth[] = {"", "0.001"};

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
  // Of a level about wrong verdicts alone, whatever their cause; null for any other.
  AllowedDepths (*allowed)(const AskedLevel&) = nullptr;
  bool is_about_causes = false;  // of wrong verdicts: met where none is wrong
  // The share that each family has to decide for the other levels too. Throws Error that says what would be right.
  double (*decided_share)(const AskedLevel&) = nullptr;
  const char* breaking = "break it";  // what queries do that do not meet it: levels allow wrong answers
  // A certificate asks it with each of these arguments; the empty one is none. With a yardstick, of each other kernel.
  std::span<const std::string_view> in_certificates = no_arguments;
  std::optional<Badge> badge = {};
  const char* advice = nullptr;  // what it asks, for whoever requires nothing; of the level that a page advises

  std::string_view name() const;
};

// In the order in which they are listed.
std::span<const GateLevel* const> gate_levels();
// Those with a badge, of the lowest rank first.
std::vector<const GateLevel*> badge_levels();

// For levels that take a depth: the argument as a share of the scene. Throws Error that names the level.
double depth_argument(const AskedLevel& asked);
void accept_no_argument(const AskedLevel& asked);  // for levels that take none: the parser has refused it already

}  // namespace axiscert
