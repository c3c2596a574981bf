// Small integers on which the published formulae never round, so that any wrong answer is due to the formulae
// themselves.
#include "fuzz/families/sphere_triangle/parts/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/families/sphere_triangle/lattice.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/families/sphere_triangle/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

// Coordinates in [-m, m], radii that are halves up to `radius_in_halves` / 2. Let D = 2m bound the coordinates of every
// difference of two points, so that its length is at most sqrt(3) D. With h <= sqrt(3) D the distance from P to a line:
//   e1 = |AB|^2 <= 3 D^2,  |d1| <= 3 D^2,  |V|^2 = e <= |AB|^2 |AC|^2 <= 9 D^4,  |A . V| <= sqrt(3)^3 D^3
//   |Q1| = e1 h <= sqrt(27) D^3,  |QC| <= |C| e1 + |Q1| <= 2 sqrt(27) D^3
//   the partial sums of Q1 . QC: at most |Q1| |QC| <= 54 D^6; of Q1 . Q1 and d d: at most 27 D^6
//   four times rr e and rr e1 e1 (an integer, r being a half): at most (2r)^2 9 D^4
// All are integers, exact below 2^digits.
template <class Real>
struct Bounds {
  static constexpr std::int64_t m = sizeof(Real) == 4 ? 4 : 117;
  static constexpr std::int64_t radius_in_halves = sizeof(Real) == 4 ? 21 : 577;
};
template <class Real>
constexpr bool exact_within_bounds() {
  constexpr std::int64_t limit = std::int64_t{1} << std::numeric_limits<Real>::digits;
  constexpr std::int64_t d2 = 4 * Bounds<Real>::m * Bounds<Real>::m, h = Bounds<Real>::radius_in_halves;
  return 54 * d2 * d2 * d2 <= limit && h * h * 9 * d2 * d2 <= limit;
}
static_assert(exact_within_bounds<float>() && exact_within_bounds<double>());

// The smallest lattices, where vertices coincide and comparisons tie, alternate with the largest.
struct Lattice {
  static constexpr bool solves = false;
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    using B = Bounds<hn::TFromD<typename Random::D>>;
    static constexpr std::array<std::int64_t, 3> sizes = {1, 2, B::m};
    const T m = in_turn<Random, 3>(first, [](std::uint64_t k) { return sizes[k]; });
    const auto coordinates = in_turn_words<Random, 3>(first, [](std::uint64_t k) { return 2 * sizes[k] + 1; });
    // Four m exceeds most distances between lattice points.
    const auto radii = in_turn_words<Random, 3>(
        first, [](std::uint64_t k) { return std::min(8 * sizes[k], B::radius_in_halves) + 1; });
    const auto point = [&]() HWY_ATTR {
      const T x = Random::number(random.below(coordinates)) - m, y = Random::number(random.below(coordinates)) - m;
      const T z = Random::number(random.below(coordinates)) - m;
      return Vec3<T>{x, y, z};
    };
    LaneQuery<T> q;
    for (Vec3<T>& v : q.v) v = point();
    q.p = point();
    random.word();  // unused; formerly a thirteenth coordinate
    q.r = Random::number(random.below(radii)) * Random::constant(0.5);
    return q;
  }
};

}  // namespace
AXISCERT_FILL(lattice, Lattice)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(lattice)
extern const Family lattice_family = {"lattice",
                                      "small integers, radii in halves: every operation of the formulae is exact",
                                      2,
                                      true,
                                      lattice_queries<float>,
                                      lattice_queries<double>};
}  // namespace axiscert
#endif
