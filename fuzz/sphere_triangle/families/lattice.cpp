// Small integers on which the published formulae never round, so that any wrong answer is due to the formulae
// themselves.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/lattice.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

// The smallest lattices, where vertices coincide and comparisons tie, alternate with the largest.
struct Lattice {
  static constexpr bool solves = false;
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    using B = LatticeBounds<hn::TFromD<typename Random::D>>;
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
extern const Family lattice_family = {sphere_triangle_predicate,
                                      "lattice",
                                      "small integers, radii in halves: every operation of the formulae is exact",
                                      2,
                                      true,
                                      lattice_queries<float>,
                                      lattice_queries<double>};
}  // namespace axiscert
#endif
