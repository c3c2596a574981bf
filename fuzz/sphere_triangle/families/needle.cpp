// Triangles with two vertices very close to each other.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/needle.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

// The two vertices lie near the origin; if the triangle is then moved away, rounding can make them equal.
struct Needle : AimedRadii {
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    constexpr int most_halvings = sizeof(hn::TFromD<typename Random::D>) == 4 ? 30 : 60;
    const auto halvings = in_turn_words<Random, most_halvings>(first, [](std::uint64_t step) { return 1 + step; });
    const auto spread = vertices_in_cube(random);
    const T size = halved_one<Random>(halvings);
    LaneQuery<T> q;
    q.v = shuffled(random, LaneVertices<T>{spread[0] * size, spread[1] * size, spread[2]});
    place(random, halvings, q);
    aim(random, q);
    return q;
  }
};

}  // namespace
AXISCERT_FILL(needle, Needle)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(needle)
extern const Family needle_family = {
    sphere_triangle_predicate,
    "needle",
    "two vertices near each other, at 2^-1 to 2^-30 of the distance to the third (2^-60 in binary64)",
    2,
    false,
    needle_queries<float>,
    needle_queries<double>,
    TrustGroup::thin};
}  // namespace axiscert
#endif
