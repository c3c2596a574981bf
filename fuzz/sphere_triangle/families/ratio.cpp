// Radius, distance and edge length of very different sizes, independently.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/ratio.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Ratio {
  static constexpr bool solves = false;
  static constexpr int most_halvings = 40, steps = 2 * most_halvings + 1;

  static double distance_size(std::uint64_t position) {
    return std::ldexp(1.0, static_cast<int>(position) - most_halvings);  // for the position modulo steps
  }
  static double radius_size(std::uint64_t position) {
    const auto step = static_cast<int>(position / steps % (steps + 1));
    return step < steps ? std::ldexp(1.0, step - most_halvings) : 0;  // at the last step the radius is zero
  }

  // One vertex is the origin, so that the centre can be arbitrarily near to it.
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    const Vec3<T> x = in_cube(random), y = in_cube(random);
    const T edge = length(x);
    const Vec3<T> towards = at_unit_length(in_cube(random));
    const T zero = Random::constant(0);
    LaneQuery<T> q;
    q.p = towards * edge * in_turn<Random, steps>(first, distance_size);
    q.r = edge * (random.unit() + Random::constant(0.5)) * by_position<Random>(first, radius_size);
    q.v = shuffled(random, LaneVertices<T>{Vec3<T>{zero, zero, zero}, x, y});
    return q;
  }
};

}  // namespace
AXISCERT_FILL(ratio, Ratio)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(ratio)
extern const Family ratio_family = {sphere_triangle_predicate,
                                    "ratio",
                                    "r / edge and |A - P| / edge over 2^-40 to 2^40, independently, in turn; r = 0 too",
                                    2,
                                    false,
                                    ratio_queries<float>,
                                    ratio_queries<double>,
                                    TrustGroup::thin};
}  // namespace axiscert
#endif
