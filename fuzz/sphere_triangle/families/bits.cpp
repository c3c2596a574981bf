// Uniform finite bit patterns: all exponents are equally likely, so a query has thirteen different magnitudes.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/bits.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Bits {
  static constexpr bool solves = false;

  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static T finite_pattern(Random& random) {
    using Limits = std::numeric_limits<hn::TFromD<typename Random::D>>;
    using Word = hn::TFromD<typename Random::DW>;
    typename Random::DW d;
    constexpr Word sign = Word{1} << (8 * sizeof(Word) - 1), top_of_exponent = sign >> 1;
    constexpr Word exponent = (sign - 1) & ~((Word{1} << (Limits::digits - 1)) - 1);
    auto pattern = random.word();
    if constexpr (sizeof(Word) == 8) {
      const auto low = random.word();
      pattern = hn::Or(hn::ShiftLeft<32>(pattern), low);
    }
    // Infinities and NaNs are mapped to [1, 2).
    const auto every_bit = hn::Set(d, exponent);
    const auto not_finite = hn::Eq(hn::And(pattern, every_bit), every_bit);
    const auto lowered = hn::Xor(pattern, hn::Set(d, top_of_exponent));
    return {hn::BitCast(typename Random::D(), hn::IfThenElse(not_finite, lowered, pattern))};
  }
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static Vec3<T> finite_point(Random& random) {
    const T x = finite_pattern(random), y = finite_pattern(random), z = finite_pattern(random);
    return {x, y, z};
  }

  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t) {
    LaneQuery<T> q;
    for (Vec3<T>& v : q.v) v = finite_point(random);
    q.p = finite_point(random);
    q.r = magnitude(finite_pattern(random));
    return q;
  }
};

}  // namespace
AXISCERT_FILL(bits, Bits)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(bits)
extern const Family bits_family = {sphere_triangle_predicate,
                                   "bits",
                                   "uniform finite bit patterns, the radius without its sign",
                                   2,
                                   false,
                                   bits_queries<float>,
                                   bits_queries<double>,
                                   std::nullopt,
                                   17,
                                   4};
}  // namespace axiscert
#endif
