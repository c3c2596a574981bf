// A family: a named generator of related queries. A new one is a file in fuzz/families/sphere_triangle and a line in
// fuzz/queries/family.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fuzz/queries/stream_name.h"
#include "kernel/query.h"

namespace axiscert {

class Stream;

// The way in which a family makes its queries: one at a time from a stream, or a batch of them at once, in lanes.
template <class Real>
class Maker {
 public:
  // `position` counts the queries of the family and determines everything that is done "in turn"; the rest comes from
  // the stream.
  using One = Query<Real> (*)(Stream& random, std::uint64_t position);
  // Makes the queries from position `first` on, as many as the columns have. The query at a position depends on nothing
  // else: not on the start of the batch, the instruction set or the compiler.
  using Batch = void (*)(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out);

  constexpr Maker(One one) : one_(one) {}
  constexpr Maker(Batch batch) : batch_(batch) {}
  void fill(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) const;

 private:
  One one_ = nullptr;
  Batch batch_ = nullptr;
};

struct Family {
  std::string_view name;
  std::string_view purpose;  // one line
  // Has to be raised whenever the same address would make another query; the committed digests fail until it is.
  int version;
  // Whether the precision's arithmetic is exact on every query, so that rounding cannot be to blame.
  bool exact_arithmetic;
  Maker<float> binary32;
  Maker<double> binary64;
  // About how many times as long as a query of `general` one of these takes in binary64, where that is ten times or
  // more. `axiscert families` shows it, and ./dev certify asks fewer of what it shows there.
  int cost = 1;
  // Divides the number of queries in binary64 of a run that is given none (cli/options/run_options.cpp).
  int trial_divisor = 1;

  template <class Real>
  void fill(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    const StreamName stream(seed, name_hash(name), version, precision_of<Real>);
    if constexpr (sizeof(Real) == 4) binary32.fill(stream, first, out);
    else binary64.fill(stream, first, out);
  }
  template <class Real>
  Query<Real> make(std::uint64_t seed, std::uint64_t position) const {
    return filled_query<Real>([&](const MutableColumns<Real>& one) { fill(seed, position, one); });
  }
};

std::span<const Family* const> families();
// Throws Error that lists the families that exist.
const Family& find_family(std::string_view name);

}  // namespace axiscert
