// A family: a named generator of related queries. A new one is a file in fuzz/families and a line in fuzz/family.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "fuzz/random.h"
#include "kernel/query.h"

namespace axiscert {

struct Family {
  std::string_view name;
  std::string_view purpose;  // one line
  // Raised whenever the same address would make another query; the committed digests fail until it is.
  int version;
  // The precision's arithmetic is exact on every query: no rounding to blame.
  bool exact_arithmetic;
  // `position` counts the queries of the family: what is asked "in turn" goes by it; the rest comes from the stream.
  Query<float> (*binary32)(Stream& random, std::uint64_t position);
  Query<double> (*binary64)(Stream& random, std::uint64_t position);

  template <class Real>
  Query<Real> make(std::uint64_t seed, std::uint64_t position) const {
    Stream random(seed, name_hash(name), version, precision_of<Real>, position);
    if constexpr (sizeof(Real) == 4) return binary32(random, position);
    else return binary64(random, position);
  }
};

std::span<const Family* const> families();
// Throws Error naming the families that exist.
const Family& find_family(std::string_view name);

}  // namespace axiscert
