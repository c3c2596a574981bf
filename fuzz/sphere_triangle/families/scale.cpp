// Clear queries at every power of two of the precision: faults are due to range, not rounding.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/scale.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Scale {
  static constexpr bool solves = true;

  // From the power that leaves one bit of a subnormal to the power at which products just remain finite.
  template <class Real>
  static Real size(std::uint64_t position) {
    using Limits = std::numeric_limits<Real>;
    constexpr int least = Limits::min_exponent - Limits::digits, greatest = Limits::max_exponent - 1;
    return std::ldexp(Real(1), least + static_cast<int>(position % (greatest - least + 1)));
  }

  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t) {
    LaneQuery<T> q;
    q.v = vertices_in_cube(random);
    q.p = in_cube(random);
    q.r = Random::constant(0);
    q.wishes[0] = random.unit() * Random::constant(0.5);
    q.wishes[1] = random.sign();
    return q;
  }

  // Wishes: a fraction of the distance, or the amount added to twice the distance; and whether the radius is to be
  // below. The radius is half the distance or less, or twice the distance or more, and below two. Then all numbers are
  // multiplied by a power of two, with one rounding, also into the subnormals.
  template <class Real>
  static void finish(std::uint64_t first, const MutableColumns<Real>& queries, const shapes::Wishes<Real>& wishes) {
    for (std::size_t i = 0; i < queries.size; ++i) {
      const Real share = wishes[0][i], distance = radius_at_distance(query_from(queries[i])),
                 times = size<Real>(first + i);
      const bool separated = wishes[1][i] > 0 || distance >= Real(0.5);
      queries.column[12][i] = separated ? distance * share : distance * 2 + share;
      for (std::size_t k = 0; k < queries.count; ++k) queries.column[k][i] *= times;
    }
  }
};

}  // namespace
AXISCERT_FILL(scale, Scale)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(scale)
extern const Family scale_family = {
    sphere_triangle_predicate,
    "scale",
    "clear queries (r at most half the distance, or at least twice) times every power of two in turn",
    2,
    false,
    scale_queries<float>,
    scale_queries<double>,
    TrustGroup::small};
}  // namespace axiscert
#endif
