// The ends of what an operation may give, in a vector's lanes, for the instruction set that foreach_target is
// compiling: as kernel/permitted/permissions.h. Where results are faithful the processor rounds upward.
#include <limits>

#include "kernel/base/per_target.h"
#include "kernel/permitted/permissions.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::permitted {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<float>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float least_normal = std::numeric_limits<float>::min();

// The greatest and the negated least of what may be.
struct Ends {
  V greatest, negated_least;
};
AXISCERT_INLINE Ends negative(const Ends& a) { return {a.negated_least, a.greatest}; }
AXISCERT_INLINE Ends joined(const Ends& a, const Ends& b) {
  return {hn::Max(a.greatest, b.greatest), hn::Max(a.negated_least, b.negated_least)};
}
AXISCERT_INLINE M is_finite(const Ends& a) {
  const V most = hn::Set(d, infinity);
  return hn::And(hn::Lt(hn::Abs(a.greatest), most), hn::Lt(hn::Abs(a.negated_least), most));
}
AXISCERT_INLINE Ends where(M is_determinate, const Ends& a) {
  const V any = hn::Set(d, infinity);
  return {hn::IfThenElse(is_determinate, a.greatest, any), hn::IfThenElse(is_determinate, a.negated_least, any)};
}

AXISCERT_INLINE Ends sum_of(const Ends& a, const Ends& b) {
  return {hn::Add(a.greatest, b.greatest), hn::Add(a.negated_least, b.negated_least)};
}
// The products and the negated products of all pairs of ends.
AXISCERT_INLINE Ends product_of(const Ends& a, const Ends& b) {
  const V greatest = hn::Neg(a.greatest), least = hn::Neg(a.negated_least);
  return {hn::Max(hn::Max(hn::Mul(a.greatest, b.greatest), hn::Mul(a.negated_least, b.negated_least)),
                  hn::Max(hn::Mul(greatest, b.negated_least), hn::Mul(least, b.greatest))),
          hn::Max(hn::Max(hn::Mul(greatest, b.greatest), hn::Mul(least, b.negated_least)),
                  hn::Max(hn::Mul(a.greatest, b.negated_least), hn::Mul(a.negated_least, b.greatest)))};
}

AXISCERT_INLINE Ends flushed(const Permissions& permissions, const Ends& a) {
  if (!permissions.flushed) return a;
  const V zero = hn::Zero(d), most = hn::Set(d, -least_normal);
  const auto one = [&](V v) HWY_ATTR { return hn::IfThenElse(hn::And(hn::Lt(v, zero), hn::Gt(v, most)), zero, v); };
  return {one(a.greatest), one(a.negated_least)};
}

// Within 2.5 ulp one after the other: they are few. A divisor that is 0 makes any value, and rounded_quotient says
// so.
inline Ends quotient_of(const Permissions& permissions, const Ends& a, const Ends& b) {
  if (!permissions.divided) {
    const V x = hn::Neg(a.negated_least), y = hn::Neg(b.negated_least);
    const auto greatest = [&](V least_a, V greatest_a) HWY_ATTR {
      return hn::Max(hn::Max(hn::Div(least_a, y), hn::Div(least_a, b.greatest)),
                     hn::Max(hn::Div(greatest_a, y), hn::Div(greatest_a, b.greatest)));
    };
    const V zero = hn::Zero(d);
    return where(hn::And(hn::Ne(y, zero), hn::Ne(b.greatest, zero)),
                 {greatest(x, a.greatest), greatest(a.negated_least, hn::Neg(a.greatest))});
  }
  float x[2][lanes], y[2][lanes];
  hn::StoreU(a.greatest, d, x[0]);
  hn::StoreU(a.negated_least, d, x[1]);
  hn::StoreU(b.greatest, d, y[0]);
  hn::StoreU(b.negated_least, d, y[1]);
  for (std::size_t i = 0; i < lanes; ++i) {
    const Reach q = permitted::quotient_of(permissions, {-x[1][i], x[0][i]}, {-y[1][i], y[0][i]});
    x[0][i] = q.greatest;
    x[1][i] = -q.least;
  }
  return {hn::LoadU(d, x[0]), hn::LoadU(d, x[1])};
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::permitted
HWY_AFTER_NAMESPACE();
