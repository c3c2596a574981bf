// Triangles with one vertex almost on the segment of the other two, down to heights far below the rounding of their
// coordinates.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/sliver.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

// The segment runs through the origin exactly, from -m D to n D in integers of few bits, so that the third vertex, near
// the origin where floats are dense, can be arbitrarily near to it. Half of the triangles are then moved away, where
// rounding of the coordinates limits the ratio.
struct Sliver : AimedRadii {
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    using Real = hn::TFromD<typename Random::D>;
    constexpr int half_digits = sizeof(Real) == 4 ? 11 : 25;
    constexpr int most_halvings = sizeof(Real) == 4 ? 40 : 80;
    const auto halvings = in_turn_words<Random, most_halvings>(first, [](std::uint64_t step) { return 1 + step; });
    const Vec3<T> d = integers(random, 1 << half_digits);
    const T m = random.integer(1, 1 << half_digits), n = random.integer(1, 1 << half_digits);
    const T size = Random::constant(sizeof(Real) == 4 ? Real(0x1p-22) : Real(0x1p-50));
    static_assert(half_digits * 2 == (sizeof(Real) == 4 ? 22 : 50));
    const Vec3<T> x = d * (Random::constant(0) - m) * size, y = d * n * size;

    const Vec3<T> along = y - x, aside = at_unit_length(cross(along, in_cube(random)));
    const Vec3<T> z = aside * length(along) * halved_one<Random>(halvings);
    LaneQuery<T> q;
    q.v = shuffled(random, LaneVertices<T>{x, y, z});
    place(random, halvings, q);
    aim(random, q);
    return q;
  }
};

}  // namespace
AXISCERT_FILL(sliver, Sliver)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(sliver)
extern const Family sliver_family = {
    sphere_triangle_predicate,
    "sliver",
    "one vertex near the segment of the other two, at 2^-1 to 2^-40 of its length (2^-80 in binary64)",
    2,
    false,
    sliver_queries<float>,
    sliver_queries<double>,
    TrustGroup::thin};
}  // namespace axiscert
#endif
