// The size of an absolute number in a kernel, an epsilon, clamp or threshold: estimated from queries that it has right
// at one scale and wrong at another. A message needs it; no count depends on it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

// A clear base that is answered rightly times 2^right and wrongly times 2^wrong.
struct UnitFlip {
  std::uint64_t base;  // position
  Verdict truth;
  int right, wrong;
};
inline constexpr std::size_t most_unit_flips = 256;

// Asks the kernel between the two powers of each flip until they are neighbours.
void narrow(const SeededSource& of, const Kernel& kernel, const std::string& target, std::vector<UnitFlip>& flips);

// Something of a query with a size, that multiplies by s^degree where every number is multiplied by s. One of the whole
// scene is named after others, since scenes of a family have nearly the same.
struct Quantity {
  std::string_view text;
  int degree;
  bool is_of_scene = false;
};
struct Quantities {
  std::span<const Quantity> all;
  // The quantities of a valid query in an entry of the predicate, in that order and in double: four digits would do. 0:
  // the query has none of it.
  std::vector<double> (*values_of)(std::size_t entry, const Numbers<double>& query);
  // In double, by which a search is guided: the depth of a valid query, negative where the shapes are apart, of which
  // boxes have the gap in place of the distance. Null where it is not told.
  double (*rough_depth)(std::size_t entry, const Numbers<double>& query) = nullptr;

  template <class Real>
  std::vector<double> values(std::size_t entry, const Numbers<Real>& query) const {
    return values_of(entry, in_doubles(query));
  }
};

// A number with which the quantity was compared: all that is known is that it lies between two values.
struct AbsoluteSize {
  Quantity quantity;
  double least, greatest;
  std::uint64_t explains;  // flips for which the quantity passes the number between `right` and `wrong`
};

// The values of all quantities of a base, which is answered rightly times 2^right and wrongly times 2^wrong.
struct MeasuredFlip {
  std::vector<double> values;
  int right, wrong;
};

// The quantities that explain most of the flips, at least three quarters of them; three at most, those of the least
// degree first.
std::vector<AbsoluteSize> absolute_sizes(std::span<const Quantity> quantities, std::span<const MeasuredFlip> flips);
// The same of a source's flips. None for a predicate that names no quantities (fuzz/queries/capabilities.h).
std::vector<AbsoluteSize> absolute_sizes(const SeededSource& of, std::span<const UnitFlip> flips);

}  // namespace axiscert
