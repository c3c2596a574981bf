// The scenes that margins of r are told apart by: their size, and whether the triangle is one to measure a kernel by.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "kernel/query.h"
#include "kernel/test.h"

namespace axiscert {

// The queries of one margin: 10^decade <= size < 10^(decade + 1), where the size is the greatest of r and the
// coordinates of all points as seen from the sphere's centre. A size of 0 has the least decade.
//
// A degenerate query has a triangle without area, or one whose least height is below 2^-10 of its longest edge, or
// lengths outside those for which formulae of degree 6 keep to the normal numbers: the classes `scale`, `repeated`,
// `collinear` and `sliver` of exact/sphere_triangle/measures/input_class.h, on the triangle, the centre and r. There a
// kernel may miss by its formulae as much as it likes, and r would have to grow to the size of the triangle.
struct MarginScene {
  bool is_degenerate = false;
  int decade = 0;
  auto operator<=>(const MarginScene&) const = default;
};

// The columns of a test's first entry, as a scene is measured by them.
class SceneMeasure {
 public:
  explicit SceneMeasure(const TestDescription& test);

  template <class Real>
  double size(const Numbers<Real>& query) const;
  // Precondition: every number is finite.
  template <class Real>
  MarginScene of(const Numbers<Real>& query) const;

 private:
  const std::vector<TestColumn>& columns_;
  std::vector<std::optional<std::size_t>> centre_;
  std::optional<std::size_t> a_, b_, c_, p_, r_;  // the first columns of a sphere and a triangle, where there are some
};

}  // namespace axiscert
