// The description of a predicate as data. Code that handles answers goes by it and is written once for all predicates.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/names.h"
#include "kernel/query.h"

namespace axiscert {

// The meaning of a column decides what may be done to it: a translation does not move a direction.
enum class Role : std::uint8_t { coordinate, direction, length, time };
template <>
inline constexpr std::size_t enum_count<Role> = 4;
inline constexpr EnumArray<Role, std::string_view> role_names = {"coordinate", "direction", "length", "time"};
constexpr std::string_view name(Role role) { return role_names[role]; }

struct PredicateColumn {
  std::string_view name;
  Role role;
  // Columns of one group belong together, as the three of a vertex do. Its name is where a line of JSON has it: with
  // dots the path in nested members: `a.m` is member `m` of the object `a`, and `b.0` the first of the array `b`.
  std::string_view group;
};

// A form in which the numbers of a query can be given.
struct PredicateEntry {
  std::string_view name;
  std::string_view validity;  // the condition for a query; other numbers are `invalid`
  std::vector<PredicateColumn> columns;
  // Queries of a file that share so many numbers, the first ones, are not independent of each other; 0: all numbers.
  std::size_t shared_columns = 0;
  bool has_free_numbers = true;  // each can be changed alone, as search, shrink and map do
};

// Neighbouring columns of one group: `size` of them from column `first` on.
struct ColumnGroup {
  std::string_view name;
  std::size_t first, size;
};
std::vector<ColumnGroup> groups_of(const PredicateEntry& entry);

struct PredicateComparison {
  std::string_view name;
  std::size_t clause;
  bool ties_at_touching = true;  // its sides are equal where it decides that the two touch
};

// A clause is a conjunction of comparisons; in a predicate by separating axes, an axis.
struct PredicateClause {
  std::string_view name;
  ComparisonBits comparisons;  // the clause holds where all of these do; bit i is comparison i
};

// The meaning of a number beside the verdict decides how it is judged (exact/judge/contact_judgement.h). A vector is
// three measures of one kind after each other: x, y and z.
enum class MeasureKind : std::uint8_t {
  other,       // not judged
  time,        // of a first contact: the predicate is one of motions
  separation,  // the distance of the two where they are apart, less their penetration where not
  feature,     // the part of the triangle that is nearest: 0 to 6
  normal,      // in which the first body pushes the second: of a sphere, from the triangle's point to the centre
  point,       // of the one body that has such a point: the triangle
  point_a,     // of the first body of two, and of the second
  point_b,
};
template <>
inline constexpr std::size_t enum_count<MeasureKind> = 8;
inline constexpr EnumArray<MeasureKind, std::string_view> measure_kind_names = {
    "other", "time", "separation", "feature", "normal", "point", "point_a", "point_b"};
constexpr std::string_view name(MeasureKind kind) { return measure_kind_names[kind]; }

// A number beside the verdict, for example a time of impact.
struct PredicateMeasure {
  std::string_view name, unit;
  std::string_view error;  // how its error is counted
  MeasureKind kind = MeasureKind::other;
};

// The name of a wrong answer: a kernel says one verdict and another is right.
struct WrongAnswer {
  Verdict said, right;
  std::string_view name;
};

// The way in which clauses make the verdict.
struct VerdictRule {
  std::string_view text;
  // True of comparison bits that separate. Null: bits separate where a clause holds.
  bool (*separates)(ComparisonBits comparisons) = nullptr;
};
inline constexpr VerdictRule any_clause_separates = {"separated where any clause holds"};

// Limits that a word of 64 bits and the plug-in interface set; the third is most_columns (kernel/query.h).
inline constexpr std::size_t most_comparisons = 64, most_measures = 64;

struct Predicate {
  std::string_view id;
  std::string_view asks;      // one line
  std::string_view touching;  // the case in which the two touch
  std::vector<WrongAnswer> wrong_answers;
  std::vector<PredicateEntry> entries;  // a kernel that names none takes the first
  std::vector<PredicateComparison> comparisons;
  std::vector<PredicateClause> clauses;
  std::vector<PredicateMeasure> measures;
  VerdictRule rule = any_clause_separates;
  std::string_view certified = {};  // its kernel that is proved to be right on every query; empty: it has none
  // The built-in kernel whose formulae a plug-in or a program with comparisons has that names none; empty: it has to
  // name one.
  std::string_view usual_formulae = {};
  // Kernel::strictness says how a kernel compares its sides where they do not tie at touching; there all compare by
  // `>`.
  bool has_strictness = false;
  // A kernel's claim names an arithmetic too (Kernel::arithmetic); else it is of the formulae alone.
  bool claims_arithmetic = false;
  std::vector<std::string_view> methods = {};  // formulae that have only a verdict, without comparisons
  double greatest_depth = 1;                   // of a wrong verdict (docs/error_model.md#depth), rounded up
  // Kernels may promise the front side of its triangle alone, by the centre of the other shape (Limits::sides). False
  // too for a predicate of motions, where the motion says what is in front.
  bool has_front = false;
  bool is_implied = false;  // files, plans, programs and ids that name no predicate are about this one
};

// The first of the measures of a kind; empty where the predicate has none.
std::optional<std::size_t> first_measure(const Predicate& predicate, MeasureKind kind);
inline bool has_measure(const Predicate& predicate, MeasureKind kind) {
  return first_measure(predicate, kind).has_value();
}
// Whether all of that kind are among the first `count` measures.
bool gives_measure(const Predicate& predicate, std::size_t count, MeasureKind kind);
// Whether something moves: contact is then a first one, at a time, and nothing is said beside the verdict `separated`.
inline bool is_of_motions(const Predicate& predicate) { return has_measure(predicate, MeasureKind::time); }

// Returns the description unchanged. Throws HarnessFault if it has no entry, too many of anything, the same name twice,
// a group whose columns are not neighbours, or a comparison that its clause does not contain.
Predicate checked(Predicate predicate);

// The bits of all comparisons.
ComparisonBits all_comparisons(const Predicate& predicate);
// Bit i is clause i.
ClauseBits clauses_of(const Predicate& predicate, ComparisonBits comparisons);
Verdict verdict_of(const Predicate& predicate, ComparisonBits comparisons);

// The index of an entry; an empty name means the first. Throws Error naming those that exist, the most alike first.
std::size_t find_entry(const Predicate& predicate, std::string_view name);

// The predicates that exist; defined in kernel/registry/predicates.cpp. find_predicate throws Error as find_entry does.
std::span<const Predicate* const> predicates();
const Predicate& find_predicate(std::string_view id, std::span<const Predicate* const> known = predicates());

// What a file, plan or program says of a predicate: its id, and nothing of the implied one. predicate_named reads that
// back; it throws Error as find_predicate does.
std::string_view written_name(const Predicate& predicate);
const Predicate& predicate_named(std::string_view written, std::span<const Predicate* const> known = predicates());
// "PREDICATE/", with which ids and folders of a predicate begin; empty where its name is left out.
std::string id_prefix(const Predicate& predicate);

}  // namespace axiscert
