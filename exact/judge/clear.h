// Clear queries: those that no right method of a precision can get wrong (docs/error_model.md#clear-queries). It shares
// nothing with the oracles, and no answer of theirs depends on it. The predicate's listed forms are evaluated with a
// running error bound; a query is clear where each of them has the verdict, whatever the comparisons are that its bound
// leaves open.
// - Each operation adds K = 16 times its rounding bound, u |result|, and a product K times the least normal number.
// - Every coordinate is uncertain by K u times the greatest one, as for a method that does not move the origin first.
// - A triangle's coordinates are uncertain by K u L L / h too, as for barycentric coordinates: L is its longest edge, h
//   its least height.
// - A motion's radius is uncertain by K u L L / (d + r), as for roots of quadratics, and at most sqrt(K u) L. L is how
//   far the start is from the farther end of an edge, d how far its line is from that of the path; the greatest counts.
//   A contact is clear only where the start, standing still, is clear.
// - Scenes in which a form of degree 8 leaves the range are not clear.
// The forms are ladder-0 (in the world's coordinates, with roots and divisions) and published of sphere-triangle,
// twenty-nonstrict of moving-sphere, projected and, of matrices, textbook of box-box, and thirteen of box-triangle.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "exact/judge/rough_number.h"
#include "kernel/formulae_kernel.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {

// How large and how small the lengths of a query are that are not 0: half extents and radii, and the greatest
// coordinate of each difference of two points and of each direction.
struct SceneLengths {
  double longest = 0, shortest = std::numeric_limits<double>::infinity();
  double farthest = 0;  // the greatest |coordinate|

  void note(double length);
};

// The columns of an entry by what they mean for these.
class SceneColumns {
 public:
  explicit SceneColumns(const PredicateEntry& entry);
  template <class Real>
  SceneLengths lengths(const Numbers<Real>& q) const;
  bool is_coordinate(std::size_t column) const { return roles_[column] == Role::coordinate; }
  bool is_length(std::size_t column) const { return roles_[column] == Role::length; }

 private:
  std::vector<Role> roles_;
  std::vector<ColumnGroup> points_, directions_;
  std::vector<std::size_t> lengths_;
};

// L L / h of a triangle, L its longest edge and h its least height: a method that finds the nearest point by
// barycentric coordinates, of areas that cancel, moves it by a few u of that. Infinite or not a number where there is
// no area.
double barycentric_length(const portable::Vec3<double>& a, const portable::Vec3<double>& b,
                          const portable::Vec3<double>& c);

// Whether methods of degree 8 stay within the range: the longest length to the power of 8 does, and the product of four
// of the shortest and four of the longest is normal.
template <class Real>
bool is_within_range(const SceneLengths& scene) {
  const double most = std::pow(scene.longest, 8), least = std::pow(scene.shortest * scene.longest, 4);
  return most <= std::numeric_limits<Real>::max() / clear_factor &&
         (least >= std::numeric_limits<Real>::min() * clear_factor || scene.longest == 0);
}

// The verdict of formulae F where it is the same whatever the comparisons are that are not certain.
template <class F, class Real, class Problem>
std::optional<Verdict> certain_verdict(const Predicate& predicate, const Problem& problem) {
  using Rough = RoughNumber<Real>;
  ComparisonBits open = 0;
  const auto see = [&](std::size_t i, const Rough& lhs, const Rough& rhs) {
    if (!is_certain(lhs, rhs)) open |= one_bit<ComparisonBits>(i);
  };
  const ComparisonBits holds = bits_of<F, Rough>(problem, see);
  // More comparisons that hold separate no less.
  const Verdict least = verdict_of(predicate, holds & ~open), most = verdict_of(predicate, holds | open);
  return least == most ? std::optional(least) : std::nullopt;
}

// The clear verdict by the formulae of a list; all have to be certain of one verdict. The coordinates are uncertain by
// K u of the greatest, as they are to a method that does not move the origin first, and of Test::moved_length(q); the
// lengths by K u of Test::rooted_length(q). By so much other methods take them differently.
template <class Test, class Real, class... F>
std::optional<Verdict> clear_verdict_by(FormulaeList<F...>, const Numbers<Real>& q) {
  using Rough = RoughNumber<Real>;
  const Predicate& predicate = Test::description();
  static const SceneColumns columns(predicate.entries[entry_of<Test>()]);
  const SceneLengths scene = columns.lengths(q);
  if (!is_within_range<Real>(scene)) return std::nullopt;
  double moved = rough_unit<Real> * scene.farthest;
  if constexpr (requires { Test::moved_length(q); }) moved += rough_unit<Real> * Test::moved_length(q);
  double stretched = 0;
  if constexpr (requires { Test::rooted_length(q); }) stretched = rough_unit<Real> * Test::rooted_length(q);
  if (!std::isfinite(moved) || !std::isfinite(stretched)) return std::nullopt;
  const auto problem = Test::template problem<Rough>([&](std::size_t k) {
    const auto x = static_cast<double>(q[k]);
    return Rough::within(x, columns.is_coordinate(k) ? moved : columns.is_length(k) ? stretched : 0);
  });
  std::optional<Verdict> found;
  bool is_clear = true;
  const auto ask = [&]<class One>() {
    if (!is_clear) return;
    const auto verdict = certain_verdict<One, Real>(predicate, problem);
    is_clear = verdict && (!found || *found == *verdict);
    found = verdict;
  };
  (ask.template operator()<F>(), ...);
  return is_clear ? found : std::nullopt;
}

}  // namespace axiscert
