// Motions of small integers that one of the twenty axes alone separates, by less than half a unit: each axis in turn.
#include "fuzz/moving_sphere/parts.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/formulae_kernel.h"

namespace axiscert::moving_sphere {
namespace {

// The axes that separate. Exact on small integers.
template <class Real>
ClauseBits separating_axes(const MovingQuery<Real>& q) {
  const auto ignore = [](std::size_t, Real, Real) {};
  return clauses_of(moving_sphere_predicate(), bits_of<TwentyNonstrict, Real>(q, ignore));
}

// The greatest radius, in halves, at which an axis separates, or 0. A smaller sphere is separated too.
template <class Real>
std::int64_t greatest_separated(MovingQuery<Real> q, std::int64_t most) {
  std::int64_t separated = 0;
  while (separated < most) {
    const std::int64_t middle = (separated + most + 1) / 2;
    q.r = static_cast<Real>(middle) * Real(0.5);
    if (separating_axes(q) != 0) separated = middle;
    else most = middle - 1;
  }
  return separated;
}

// In turn each axis as the only one that separates. Every fourth round the radius is the half after: in contact by less
// than a half, or touching. In binary32, of integers up to 3, an axis of a vertex at the end is the only one in two of
// a thousand motions; where none is found the last is taken that the axis and others separate.
template <class Real>
Numbers<Real> one_axis(Stream& random, std::uint64_t position) {
  constexpr int most_draws = 1024;
  constexpr std::int64_t bound = sizeof(Real) == 4 ? 3 : 90, most_halves = 8 * bound;
  const std::uint64_t axes = moving_sphere_predicate().clauses.size();
  const auto wanted = one_bit<ClauseBits>(position % axes);
  MovingQuery<Real> taken{};
  for (int draw = 0; draw < most_draws; ++draw) {
    MovingQuery<Real> q = small_integers<Real>(random, bound);
    q.r = 0;
    if ((separating_axes(q) & wanted) == 0) continue;
    q.r = static_cast<Real>(greatest_separated(q, most_halves)) * Real(0.5);
    taken = q;
    if (separating_axes(q) == wanted) break;
  }
  if (position / axes % 4 == 3) taken.r += Real(0.5);
  return taken;
}

}  // namespace

extern const Family moving_sphere_one_axis_family = moving_family<one_axis<float>, one_axis<double>>(
    "moving-sphere/one_axis", situation::small_integers,
    "small integers: each of the twenty axes in turn separates alone, by less than a half", true);

}  // namespace axiscert::moving_sphere
