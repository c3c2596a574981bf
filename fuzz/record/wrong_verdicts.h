// Wrong verdicts: how deep they are, by decade, on queries such as an engine asks, and by the class of their input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/depth.h"
#include "exact/judge/judge.h"
#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/record/leaders.h"
#include "fuzz/text/field.h"
#include "fuzz/text/values.h"
#include "kernel/kernel.h"

namespace axiscert {

// Counts of sizes by powers of ten.

// Decades of depths, and of other shares of the scene: 0 is exactly zero, as of bodies that touch; 1 is all else below
// 10^-20, too small for a double or not; then [10^k, 10^(k+1)) for k from -20 on; the last one is a share of 1 or more.
// Share and power of ten are the nearest binary64 of each.
inline constexpr int least_decade = -20;
inline constexpr std::size_t decade_count = 2 - least_decade + 1;
std::size_t decade_of(double depth);
// "zero", "less", "-20" ... "-1", "0".
std::string decade_name(std::size_t decade);

struct Decades {
  static constexpr std::size_t size = decade_count;
  static std::string name(std::size_t decade) { return decade_name(decade); }
  static constexpr std::string_view about =
      "Counts by decade: k is depths, or other shares of the scene, from 10^k to below 10^(k+1), zero exactly that, as "
      "of "
      "touching, less all others below 10^-20, too small for a double or not. Each and the power of ten are the "
      "nearest "
      "binary64. A decade without a count is not written.";
};
using DecadeCounts = SparseCounts<Decades>;

std::size_t decade_of(DepthOf& depth);

// Wrong verdicts by direction and decade.
struct DepthTally {
  DecadeCounts false_separation{}, false_contact{};
  std::uint64_t deep = 0;

  DecadeCounts& of(FlipKind kind) { return kind == FlipKind::false_separation ? false_separation : false_contact; }
  void count(FlipKind kind, std::size_t decade);
  bool operator==(const DepthTally&) const = default;

  static constexpr std::string_view about = "Wrong verdicts by decade of depth.";
  AXISCERT_FIELDS(DepthTally, AXISCERT_FIELD(false_separation, "Missed contacts."),
                  AXISCERT_FIELD(false_contact, "Phantom contacts."),
                  AXISCERT_FIELD(deep, "Wrong verdicts of both directions whose depth is at least 1e-3."))
};

// Queries that a kernel decided, by the verdict that is right. What they are is said where a struct has them as fields.
struct DecidedCounts {
  std::uint64_t decided_contacts = 0, decided_separations = 0;

  std::uint64_t& decided_as(Verdict right) {
    return right == Verdict::contact ? decided_contacts : decided_separations;
  }
  std::uint64_t decided() const { return decided_contacts + decided_separations; }
};

// Wrong verdicts on queries such as an engine asks (DepthOf::engine_threshold).
struct EngineTally : DecidedCounts {
  std::uint64_t queries = 0;
  DepthTally wrong;

  std::uint64_t false_separation() const { return wrong.false_separation.sum(); }
  std::uint64_t false_contact() const { return wrong.false_contact.sum(); }

  static constexpr std::string_view about =
      "Results on engine-like queries: every number is zero or normal, no |coordinate| is above 2^20, and the radius "
      "is "
      "from 2^-20 to 2^20. Wrong verdicts count where their depth is above 16 u.";
  AXISCERT_FIELDS(EngineTally, AXISCERT_FIELD(queries, "Engine-like queries within the kernel's limits."),
                  AXISCERT_FIELD(decided_contacts, "Contacts among them that the kernel decided."),
                  AXISCERT_FIELD(decided_separations, "Separations among them that it decided."),
                  AXISCERT_FIELD(decided, "Both together."),
                  field(&Of::false_separation, figure_of("decided_contacts", "false_separation",
                                                         "Missed contacts among them, deeper than 16 u.")),
                  field(&Of::false_contact, figure_of("decided_separations", "false_contact",
                                                      "Phantom contacts among them, deeper than 16 u.")),
                  field(&EngineTally::wrong, {"depths", {}}))
};

// Whether a kernel says contact for separated and separated for contact. No method is wrong so often in both
// directions.
struct WrongBothWays {
  // Queries by their truth, without those that touch, and those with the other verdict.
  std::uint64_t separated = 0, false_contact = 0;
  std::uint64_t contact = 0, false_separation = 0;

  // At least 95 % in each direction, of at least 64 queries.
  bool are_exchanged() const;
  std::string text(const Kernel& kernel) const;  // what was given, and what would be right
};

// Counts a wrong verdict.
void count_depth(DepthTally& depths, EngineTally& engine, FlipKind kind, DepthOf& depth);

// Wrong verdicts by the class of the input: what is known of why a kernel is wrong whose links do not say it.

// Whether wrong verdicts of a kernel are counted by class: where it has no reference, its links are `unattributed`, or
// the specification's alone. Predicates without InputClasses have none.
bool has_input_classes(const Kernel& kernel);

// A nearest kernel is looked for on this many of the first queries of a source (fuzz/confirm/nearest_kernel.h).
inline constexpr std::uint64_t nearest_queries = 1024;

struct ClassCount {
  std::uint64_t false_separation = 0, false_contact = 0;
  Leaders<double> deepest;  // of both kinds, ranked by depth

  static constexpr std::string_view about = "The wrong verdicts on input of one class.";
  AXISCERT_FIELDS(ClassCount, AXISCERT_FIELD(false_separation, "Missed contacts."),
                  AXISCERT_FIELD(false_contact, "Phantom contacts."),
                  AXISCERT_FIELD(deepest, "The greatest depth of them.", "of the scene"))
};

// Empty for a kernel without classes. The result of merging does not depend on the order.
struct ClassTally {
  EnumArray<InputClass, ClassCount> classes;
  std::vector<std::uint64_t> first_wrong;  // positions of wrong verdicts below nearest_queries, in any order

  AXISCERT_FIELDS(ClassTally, journalled(&ClassTally::classes), journalled(&ClassTally::first_wrong))
};

class DepthOf;

// Counts one wrong verdict on `q`, a query within the kernel's limits. `use_filter`: enclosures decide where they can;
// the result is the same.
template <class Real>
void count_class(ClassTally& tally, std::uint64_t position, FlipKind kind, const Query<Real>& q, bool is_touching,
                 DepthOf& depth, bool use_filter);

}  // namespace axiscert
