// A family: a named generator of related queries. A new one is a file in the room of its predicate in fuzz/families and
// a line in that room's families.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "fuzz/queries/situation.h"
#include "fuzz/queries/stream_name.h"
#include "kernel/query.h"
#include "kernel/predicate.h"

namespace axiscert {

// Makes the queries from position `first` on, as many as the columns have. The query at a position depends on nothing
// else: not on the start of the batch, the instruction set or the compiler. `position` counts the queries of the family
// and determines everything that is done "in turn"; the rest comes from the stream. A family that makes one query at a
// time is wrapped by fill_one_by_one (fuzz/queries/one_by_one.h).
template <class Real>
using Fill = void (*)(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out);

// The kinds of input of which the league says whether a kernel may be trusted with them.
enum class TrustGroup : std::uint8_t { thin, small, far, degenerate, resting, scene };
template <>
inline constexpr std::size_t enum_count<TrustGroup> = 6;
inline constexpr EnumArray<TrustGroup, std::string_view> trust_group_names = {"thin",       "small",   "far",
                                                                              "degenerate", "resting", "scene"};
constexpr std::string_view name(TrustGroup group) { return trust_group_names[group]; }

struct Family {
  const Predicate& (*predicate)();  // whose queries these are
  // As reports, addresses and the command say it; TEST/NAME where the predicate's own name is written.
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
  // Divides the number of queries in binary64 of a run that is given none (cli/options/run_options.cpp).
  int trial_divisor = 1;
  // What a wrong verdict on it says to a user; null in a predicate whose wrong verdicts have the class of their input
  // instead.
  const Situation* situation = nullptr;
  std::size_t entry = 0;  // of the predicate, in which the numbers are given

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

// The families of all predicates, and those of one.
std::span<const Family* const> families();
std::vector<const Family*> families_of(const Predicate& predicate);
// Throws Error that lists the families that exist.
const Family& find_family(std::string_view name);

}  // namespace axiscert
