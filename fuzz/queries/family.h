// A family: a named generator of related queries. A new one is a file in the room of its predicate (fuzz/NAME/families)
// and a line in that room's families.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/queries/random.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// A situation: what the family of a query says of a wrong answer, where nothing but the verdict is seen.

struct Situation {
  std::string_view name;     // stable, for files: "parallel"
  std::string_view meaning;  // of its queries: "motions parallel to the face or to an edge"
  std::string_view advice;   // to whoever has to use the kernel, a sentence
  std::string_view section;  // of the documents
};

// Those of a predicate, every family of which names one.
struct Situations {
  std::span<const Situation* const> of_families;  // the most everyday ones first
  Situation own;                                  // of the queries of meshes and files
};

constexpr Situation of_own_queries(std::string_view meaning, std::string_view section) {
  return {"own", meaning, "`axiscert check` a witness.", section};
}
inline constexpr Situation of_corpus = {"known", "queries of the corpus, which were hard once or are faults of engines",
                                        "`axiscert corpus list` says what each is about.", "docs/corpus.md#the-corpus"};

// Advice of more than one predicate.
inline constexpr std::string_view mend_units =
    "Bring the scene to a unit in which the kernel is right: `range_window` and "
    "`absolute_threshold` of the diagnosis say which.";
inline constexpr std::string_view shrink_small_integers =
    "A case is wrong or left out, or an epsilon is larger than the gap: `axiscert shrink` a "
    "witness.";

// Makes the queries from position `first` on, as many as the columns have. The query at a position depends on nothing
// else: not on the start of the batch, the instruction set or the compiler. `position` counts the queries of the family
// and determines everything that is done "in turn"; the rest comes from the stream. A family that makes one query at a
// time is wrapped by fill_one_by_one, below.
template <class Real>
using Fill = void (*)(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out);

// The kinds of input of which the league says whether a kernel may be trusted with them. Scenes are what a game asks
// every day, in metres: of any predicate, and where a kernel that is wrong by more than a rounding is seen at once.
enum class TrustGroup : std::uint8_t { thin, small, far, degenerate, resting, scene };
template <>
inline constexpr std::size_t enum_count<TrustGroup> = 6;
inline constexpr EnumArray<TrustGroup, std::string_view> trust_group_names = {"thin",       "small",   "far",
                                                                              "degenerate", "resting", "scene"};
constexpr std::string_view name(TrustGroup group) { return trust_group_names[group]; }

struct Family {
  const Predicate& (*predicate)();  // whose queries these are
  // As reports, addresses and the command say it; PREDICATE/NAME where the predicate's own name is written.
  std::string_view name;
  std::string_view purpose;  // one line
  // Has to be raised whenever the same address would make another query; the committed digests fail until it is.
  int version;
  // Whether the precision's arithmetic is exact on every query, so that rounding cannot be to blame.
  bool exact_arithmetic;
  Fill<float> binary32;
  Fill<double> binary64;
  std::optional<TrustGroup> trust_group = {};
  // About how many times as long as a query of `general` one of these takes in binary64, where that is ten times or
  // more. `axiscert families` shows it, and ./dev exhaust asks fewer of what it shows there.
  int cost = 1;
  // Divides the number of queries in binary64 of a run that is given none (plans/run_plan.cpp).
  int trial_divisor = 1;
  // What a wrong verdict on it says to a user; null in a predicate whose wrong verdicts have the class of their input
  // instead.
  const Situation* situation = nullptr;
  std::size_t entry = 0;  // of the predicate, in which the numbers are given
  // Asked where it is named alone, as `all` does not: of interest for what is said beside verdicts.
  bool is_by_name = false;

  std::size_t column_count() const { return predicate().entries[entry].columns.size(); }
  template <class Real>
  void fill(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    const StreamName stream(seed, name_hash(name), version, precision_of<Real>);
    if constexpr (sizeof(Real) == 4) binary32(stream, first, out);
    else binary64(stream, first, out);
  }
  template <class Real>
  Numbers<Real> make(std::uint64_t seed, std::uint64_t position) const {
    return filled_numbers<Real>(column_count(), [&](const MutableColumns<Real>& one) { fill(seed, position, one); });
  }
};

// The family as one of scenes.
constexpr Family in_metres(Family family) {
  family.trust_group = TrustGroup::scene;
  return family;
}

constexpr Family by_name(Family family) {
  family.is_by_name = true;
  return family;
}

// The families of all predicates; those of one that are asked where none is named, and all of it.
std::span<const Family* const> families();
std::vector<const Family*> families_of(const Predicate& predicate);
std::vector<const Family*> all_families_of(const Predicate& predicate);
// Throws Error that lists the families that exist.
const Family& find_family(std::string_view name);

// The families of a predicate whose numbers are given in one of its entries.

// In the order of families_of(predicate).
std::vector<const Family*> families_of(const Predicate& predicate, std::size_t entry);

// A family that makes its queries one at a time, each from a stream of its own.

// A Fill<Real> by one(random, position), which returns a predicate's query or its Numbers<Real>.
template <auto one, class Real>
void fill_one_by_one(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  for (std::size_t i = 0; i < out.size; ++i) {
    Stream random(name, first + i);
    out.set(i, one(random, first + i));
  }
}

}  // namespace axiscert
