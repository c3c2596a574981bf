// The scenes that margins of r are told apart by: their size, and whether the triangle is one to measure a kernel by.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "exact/trait/oracles.h"
#include "kernel/query.h"
#include "kernel/predicate.h"

namespace axiscert {

// The queries of one margin: 10^decade <= size < 10^(decade + 1), where the size is the greatest of r and the
// coordinates of all points as seen from the sphere's centre. A size of 0 has the least decade.
struct MarginScene {
  bool is_degenerate = false;  // Oracles::is_degenerate: a kernel may miss there by its formulae alone
  int decade = 0;
  auto operator<=>(const MarginScene&) const = default;
};

// The columns of a predicate's first entry, as a scene is measured by them.
class SceneMeasure {
 public:
  explicit SceneMeasure(const Predicate& predicate);

  template <class Real>
  double size(const Numbers<Real>& query) const;
  // Precondition: every number is finite.
  template <class Real>
  MarginScene of(const Numbers<Real>& query) const;

 private:
  const Oracles& oracles_;
  const std::vector<PredicateColumn>& columns_;
  std::vector<std::optional<std::size_t>> centre_;  // the column of the centre from which a column's number is seen
};

}  // namespace axiscert
