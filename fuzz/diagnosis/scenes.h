// What a diagnosis asks kernels of a predicate about: scenes of each kind, and the words that describe them. They are
// made of the predicate's families and columns, but for those that the predicate makes itself
// (Capabilities::diagnosis_scenes).
#pragma once

#include <string_view>
#include <vector>

#include "fuzz/diagnosis/subject.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/queries/random.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert::diagnosis {
// The draws of one probe: the same for a seed on every machine.
inline Stream stream_of(std::uint64_t seed, std::string_view probe, Precision precision, std::uint64_t position) {
  return Stream(seed, name_hash(probe), 1, precision, position);
}

template <class Real>
struct ClearQuery {
  Numbers<Real> numbers;
  Verdict truth;
};

// Queries that touch, whatever is rounded, with the part that is touched where that is known.
template <class Real>
struct TouchingScenes {
  Queries<Real> queries;
  std::vector<std::size_t> part;  // among the names
  std::vector<std::string_view> parts;
  std::size_t least;         // answers from which on something is said
  bool all_tell_of_slack;    // of a length that is nearly right; else those alone whose answer turns around touching
  std::string_view what;     // "spheres"
  std::string_view length;   // what grows: "radius"
  std::string_view whole;    // what is open or closed: "The sphere"
  std::string_view where;    // they touch: "at a distance of exactly r"
  std::string_view touches;  // of one of them: "the distance is the radius"
};

// A clear contact, and the side of (B - A) x (C - A) from which it comes.
template <class Real>
struct SidedQuery {
  Numbers<Real> query;
  bool is_front;
};
template <class Real>
struct SidedScenes {
  std::vector<SidedQuery<Real>> queries;
  Queries<Real> apart;  // the same scenes, separated, where these are known: an answer to one tells of the other
  std::string_view what, whose;    // "spheres", "a sphere whose centre is"
  std::string_view front, behind;  // of a contact: where it comes from
};

// A triangle without area: vertices in one place, two of them in one, or all on a line, exactly.
enum class Flat : std::uint8_t { point, two_equal, collinear };
inline constexpr std::string_view flat_names[] = {"point", "two_equal", "collinear"};
template <class Real>
struct FlatQuery {
  Numbers<Real> query;
  Flat flat;
  bool is_contact;
};
template <class Real>
struct FlatScenes {
  std::vector<FlatQuery<Real>> queries;
  std::string_view apart, contact;  // what becomes of such a triangle
};

// Radii at which answers turn are sought within this part of the distance.
inline constexpr double turning_range = 0x1p-10;
// Scenes with the column of the radius, which is the distance, rounded.
template <class Real>
struct TurningScenes {
  Queries<Real> queries;
  std::size_t radius;
  std::vector<bool> is_of_first, is_of_second;  // by column: the numbers of the two places that are read as floats
  std::string_view first, second;               // what these are
  std::optional<std::string> why_none = {};     // a sentence, where the kernel's answers say nothing of such scenes
};

// Those of a predicate's families and columns (scenes_by_trait.cpp, scenes.cpp).
template <class Real>
std::vector<ClearQuery<Real>> clear_by_depth(const Kernel& kernel, std::size_t count);
template <class Real>
TouchingScenes<Real> touching_by_trait(Subject<Real>& subject, std::size_t count);
template <class Real>
SidedScenes<Real> sided_by_trait(Subject<Real>& subject, std::size_t count);
template <class Real>
FlatScenes<Real> flat_by_trait(Subject<Real>& subject, std::size_t of_each);
template <class Real>
TurningScenes<Real> turning_by_trait(Subject<Real>& subject, std::size_t count);
template <class Real>
Queries<Real> small_of_any_degree(const Kernel& kernel);
ExponentWindow scanned_of_families(Precision precision);

inline constexpr std::size_t no_axis = 3;

// Each member makes scenes of a kernel's entry of the predicate, the same for a seed on every machine.
template <class Real>
struct Scenes {
  // Far from every boundary, at most `count`; none where the predicate has no such thing.
  std::vector<ClearQuery<Real>> (*clear)(const Kernel& kernel, std::size_t count) = clear_by_depth<Real>;
  // At most `count`; separated with half the lengths and in contact with half as much again.
  TouchingScenes<Real> (*touching)(Subject<Real>& subject, std::size_t count) = touching_by_trait<Real>;
  // At most `count`, of which half are of each side.
  SidedScenes<Real> (*sided)(Subject<Real>& subject, std::size_t count) = sided_by_trait<Real>;
  // At most `of_each` of each kind, as many contacts as separations.
  FlatScenes<Real> (*flat)(Subject<Real>& subject, std::size_t of_each) = flat_by_trait<Real>;
  // At most `count`, of predicates with a critical distance.
  TurningScenes<Real> (*turning)(Subject<Real>& subject, std::size_t count) = turning_by_trait<Real>;
  // Those that tell of subnormal numbers: intermediate results are, and where that does not tell, lengths too.
  Queries<Real> (*small)(const Kernel& kernel) = small_of_any_degree<Real>;
  // The exponents that are scanned: those times which the clear queries are exact.
  ExponentWindow (*scanned)(Precision precision) = scanned_of_families;
  // A query on which the last bit decides, of vectors and single lengths. `flat`: a coordinate that is 0 in all
  // vectors, or no_axis. Null: such are not made, and the queries of all families stand for them.
  Numbers<Real> (*near_tie)(std::uint64_t seed, std::string_view probe, std::uint64_t position,
                            std::size_t flat) = nullptr;
};

// The words for scenes that are made by trait.
struct SceneWords {
  std::string_view touching = "pairs", length = "lengths";  // TouchingScenes::what, length
  std::string_view sided = "scenes";                        // SidedScenes::what
  std::string_view front = "the centre is in front of the face", behind = "the centre is behind the face";
  std::string_view first = "one place", second = "the other";  // TurningScenes
};

struct DiagnosisScenes {
  Scenes<float> binary32 = {};
  Scenes<double> binary64 = {};
  SceneWords words = {};
};
// That of the predicate, or all by trait.
const DiagnosisScenes& diagnosis_scenes(const Predicate& predicate);
template <class Real>
const Scenes<Real>& scenes_of(const Predicate& predicate) {
  if constexpr (sizeof(Real) == 4) return diagnosis_scenes(predicate).binary32;
  else return diagnosis_scenes(predicate).binary64;
}

// Queries of the kernel's predicate and entry: near ties, or of every family in turn where none are made; and of the
// family "general".
template <class Real>
Queries<Real> sharp_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count);
template <class Real>
Queries<Real> queries_of_general(const Kernel& kernel, std::uint64_t seed, std::size_t count);

// Queries of a kernel's predicate on which no rounding is to blame for a wrong answer, and their images in another
// unit.

// The depth, relative to the scene, above which a query is clear of touching.
inline constexpr double clear_depth = 0x1p-6;

// The family of the kernel's predicate that is named "general", with the entry that the kernel takes before it or after
// it ("ends_general", "general_minmax"); null where there is none.
const Family* family_named_general(const Kernel& kernel);

// The predicate's own, or the first `count` queries of its family `general` whose depth is above 2^-6. The numbers are
// of the kernel's entry. Empty where the predicate has no depth or no such family.
template <class Real>
std::vector<ClearQuery<Real>> clear_queries(const Kernel& kernel, std::size_t count);

// Others of the kernel's predicate and entry, with parts of many sizes: near the length at which the answer turns,
// and queries of all families, most of them of those that come in other units, whose bases are near one feature. Their
// greatest number is in [1, 2).
template <class Real>
std::vector<ClearQuery<Real>> clear_of_families(Subject<Real>& subject);

// The query in another unit of length: places, lengths and displacements times 2^exponent. The axes of a box stay.
template <class Real>
Numbers<Real> in_unit(const Kernel& kernel, const Numbers<Real>& numbers, int exponent);

// Clear queries times powers of two at which intermediate results, but not the query's numbers, become subnormal:
// enough where comparisons are of a degree above 1. Those of boxes are not, and nothing becomes subnormal before their
// lengths do.
template <class Real>
Queries<Real> small_of_high_degree(const Kernel& kernel);

// Whether the kernel is right on clear queries of both verdicts at least two times in three: of one that is not, little
// can be said by its answers. The sentence says how often it is right where it is not; of a predicate without clear
// queries nothing is said.
template <class Real>
std::optional<std::string> why_not_sound(Subject<Real>& subject);

}  // namespace axiscert::diagnosis
