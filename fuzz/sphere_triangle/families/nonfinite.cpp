// One number out of thirteen that is not finite, has the wrong sign, or is a zero of either sign.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/nonfinite.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Nonfinite {
  static constexpr bool solves = true;

  template <class Real>
  static Real unusual(std::uint64_t kind, Real usual) {
    using Limits = std::numeric_limits<Real>;
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    // A quiet NaN without payload; by its bits, since its sign and payload enter the digests.
    constexpr Bits nan = (~Bits{0} >> 1) & ~((Bits{1} << (Limits::digits - 2)) - 1);
    switch (kind) {
      case 0:
        return std::bit_cast<Real>(nan);
      case 1:
        return Limits::infinity();
      case 2:
        return -Limits::infinity();
      case 3:
        return -std::abs(usual);  // an invalid radius
      case 4:
        return -Limits::denorm_min();  // the least negative radius
      case 5:
        return Real(0);
      case 6:
        return Real(-0.0);
      default:
        return Limits::max();  // valid; its square is not finite
    }
  }

  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t) {
    LaneQuery<T> q;
    q.v = vertices_in_cube(random);
    q.p = in_cube(random);
    q.r = magnitude(random.symmetric());
    const T second = random.integer(0, 3), place = random.integer(0, coordinate_count - 1), kind = random.integer(0, 7);
    const T none = Random::constant(-1);
    q.wishes[0] = select(hn::Eq(second.v, Random::constant(0).v), place, none);
    q.wishes[1] = kind;
    return q;
  }

  // Each place in turn with each kind. One query in four has a second such number, of any kind at any place: the wishes
  // are that place, or -1, and the kind.
  template <class Real>
  static void finish(std::uint64_t first, const MutableColumns<Real>& queries, const shapes::Wishes<Real>& wishes) {
    for (std::size_t i = 0; i < queries.size; ++i) {
      const std::uint64_t position = first + i;
      Real& in_turn = queries.column[position % coordinate_count][i];
      const Real usual = in_turn;
      if (wishes[0][i] >= 0) {
        Real& second = queries.column[static_cast<std::size_t>(wishes[0][i])][i];
        second = unusual(static_cast<std::uint64_t>(wishes[1][i]), second);
      }
      in_turn = unusual(position / coordinate_count % 8, usual);
    }
  }
};

}  // namespace
AXISCERT_FILL(nonfinite, Nonfinite)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(nonfinite)
extern const Family nonfinite_family = {
    sphere_triangle_predicate,
    "nonfinite",
    "NaN, infinities, negative numbers and zeros of both signs in each of the thirteen places in turn",
    2,
    false,
    nonfinite_queries<float>,
    nonfinite_queries<double>};
}  // namespace axiscert
#endif
