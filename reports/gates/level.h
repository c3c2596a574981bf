// A level of --require, and what it judges: one kernel in one precision, which is its entry of a record, with what the
// levels ask of it.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/record/record.h"
#include "reports/wording/evidence.h"

namespace axiscert {
// One way in which a kernel falls short.
struct Failure {
  std::string kernel, precision, family;  // precision and family are empty for a kernel that could not be loaded
  std::uint64_t count;                    // number of wrong verdicts, or of the cases that `what` names
  std::string what;                       // for example "missed contacts"
  std::string witness;                    // the deepest one that shows it; empty where none was stored
  bool is_beside_families = false;        // of queries that no family made: `family` says which

  std::string text() const;
  AXISCERT_FIELDS(Failure, journalled(&Of::kernel), journalled(&Of::precision),
                  AXISCERT_FIELD(family, "Empty for a kernel that could not be loaded."),
                  AXISCERT_FIELD(count, "Number of queries."), AXISCERT_FIELD(what, "What is wrong with them."),
                  AXISCERT_FIELD(witness, "The deepest one, by its id in the record; empty where none was stored."),
                  journalled(&Of::is_beside_families))
};

// A family as a level looks at it, in queries, or in pairs of a query and its image.
struct FamilyLook {
  std::uint64_t concerned = 0;  // valid ones of the plan that the level's definition concerns
  std::uint64_t looked_at = 0;  // those that are promised, and whose answer the level judged
  std::uint64_t declined = 0;   // of pairs: those with an answer `undecided`; declined queries are in the evidence
};

// "general, tangent", or "26 families".
std::string list_of(const std::vector<std::string>& families);

class Subject {
 public:
  // `kernel` is one of the record's. Both have to outlive the subject.
  Subject(const Record& record, const KernelRecord& kernel) : record_(record), kernel_(kernel) {}

  const Record& record() const { return record_; }
  const KernelRecord& kernel() const { return kernel_; }
  const NamedValues<FamilyRecord>& families() const { return kernel_.families; }

  // The cause of a wrong verdict is told by these.
  enum class Basis {
    reference,  // its formulae and their bits: every link is told apart
    formulae,   // its formulae, evaluated in its own way: range, rounding and implementation are not told apart
    verdicts    // nothing but the verdict
  };
  Basis basis() const;
  // How much of a family there is to judge it by.
  Evidence evidence(const FamilyRecord& result) const { return evidence_of(kernel_, result); }
  // The look of a level that judges every verdict of a family.
  FamilyLook whole_look(const FamilyRecord& result) const;
  // The look of one that judges pairs of a query and its image. Pairs with a query outside the limits are in no count:
  // there may be as many as such queries.
  FamilyLook pairs_look(const FamilyRecord& result, std::uint64_t compared, std::uint64_t declined) const;

  using Shows = std::function<bool(const FlipRecord& verdict_flip)>;
  // Adds a failure of this kernel, unless `count` is 0; its witness is the deepest of which a flip of the verdict
  // `shows` it.
  void add(std::vector<Failure>& failures, const std::string& family, std::uint64_t count, const std::string& what,
           const Shows& shows, bool touching_counts = true) const;
  // The same for wrong verdicts with a broken link; for an unattributed one, those in exact arithmetic.
  void add_link(std::vector<Failure>& failures, const std::string& family, Link link, std::uint64_t count) const;

  // Adds a failure of this kernel, unless `count` is 0; its witness is the first that was kept for a reason that begins
  // with `reason`.
  void add_shown(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                 const std::string& what, std::string_view reason) const;

  // Adds the contacts that say nothing of when: of a kernel that gives times, those without one in [0, 1].
  void add_untimed(std::vector<Failure>& failures) const;

  // Adds a failure of this kernel that two queries show together, unless `count` is 0; the witness is the image. Empty:
  // none is known.
  void add_pair(std::vector<Failure>& failures, const std::string& family, std::uint64_t count, const std::string& what,
                const std::optional<AddressPair>& pair) const;

  std::uint64_t wrong_verdicts() const;  // over all families
  std::uint64_t decided() const;         // over all families
  std::string list_of_families() const;  // "general, tangent", or "26 families"

 private:
  Failure failure(const std::string& family, std::uint64_t count, const std::string& what) const;
  bool is_of(const WitnessRecord& witness, const std::string& family) const;

  const Record& record_;
  const KernelRecord& kernel_;
};

// A level of --require: its name, its sentence, and how one kernel in one precision is judged by it. A new one is a
// file that defines a GateLevel, and a line in level.cpp.

// A level as it was asked for. "depth=0.01 in scene-*,far" is the level `depth` with the argument "0.01", of families
// whose names match one of these.
struct AskedLevel {
  std::string text;           // whole
  std::string name;           // before the first '='
  std::string argument = {};  // after it; empty where there is none
  bool has_argument = false;
  std::vector<std::string> families = {};  // patterns with *, ? and []; empty: all families

  bool is_about(const std::string& family) const;

  AXISCERT_FIELDS(AskedLevel, field(&Of::text, {"level", "The level as it was given."}), journalled(&Of::name),
                  journalled(&Of::argument), journalled(&Of::has_argument), journalled(&Of::families))
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

// The deepest wrong verdicts that are allowed, as shares of the scene or, `are_lengths`, in metres; below 0: none.
struct AllowedDepths {
  double missed, phantom;
  bool are_lengths = false;
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
  // States the requirement, for a report: "no missed contact". The argument is there only where `usage` has one; throws
  // Error that says what would be right.
  std::string (*sentence)(const AskedLevel&);
  LevelFindings (*judge)(const AskedLevel&, const Subject&);
  // The kernel that others are measured against, which itself has to meet no level; null where there is none.
  std::string (*yardstick)(const AskedLevel&) = nullptr;
  // The depths that a level about wrong verdicts alone allows, whatever their cause; null for any other.
  AllowedDepths (*allowed)(const AskedLevel&) = nullptr;
  bool is_about_causes = false;    // of wrong verdicts: met where none is wrong
  const char* looks_at = nullptr;  // queries beyond the kernel's promise, in words; null: those that it promises
  // In words, the promised queries that alone could break it, where it looks at no others; null: it looks at all.
  const char* (*part)(const AskedLevel&) = nullptr;
  bool asks_itself = false;  // it looks at queries of its own, and at no family
  // Whether a value of a property of a diagnosis says that the level is not met; null where none can.
  bool (*is_denied_by)(const AskedLevel&, std::string_view property, std::string_view value) = nullptr;
  // The share that each family has to decide for the other levels too. Throws Error that says what would be right.
  double (*decided_share)(const AskedLevel&) = nullptr;
  const char* breaking = "break it";  // what queries do that do not meet it: levels allow wrong answers
  // A certificate asks it with each of these arguments; the empty one is none. With a yardstick, of each other kernel.
  std::span<const std::string_view> in_certificates = no_arguments;
  std::optional<Badge> badge = {};
  const char* advice = nullptr;  // what it asks, for whoever requires nothing; of the level that a page advises

  std::string_view name() const;
};

// Adds one more thing that "met" leaves out.
inline void leave_out(std::string& leaves_out, const std::string& what) {
  leaves_out += (leaves_out.empty() ? "" : "; ") + what;
}

// In the order in which they are listed.
std::span<const GateLevel* const> gate_levels();
// Those with a badge, of the lowest rank first.
std::vector<const GateLevel*> badge_levels();

// For levels that take a number: what it is, and the greatest that says anything.
struct NumberBound {
  const char *letter, *what, *example;
  double least, most;
  bool has_six_digits = false;  // at most: the record has no more of what is compared with it
};
inline constexpr double above_0 = std::numeric_limits<double>::denorm_min();
// The argument, in the number's own unit or as a length in metres.
struct SizeLimit {
  double most;
  bool is_length = false;

  std::string text(std::string_view unit = "of the scene") const;  // "0.001 of the scene", "1 mm"
};
// These throw Error that names the level.
double number_argument(const AskedLevel& asked, const NumberBound& bound);
SizeLimit size_limit(const AskedLevel& asked, const NumberBound& bound);
SizeLimit depth_argument(const AskedLevel& asked);

}  // namespace axiscert
