// The filter's number types over Highway vectors, one query per lane: a double, and a pair of doubles. No guard:
// included once for each of Highway's instruction sets.
//
// Each operation returns the exact result times 1 + delta, |delta| <= unit, while nothing under- or overflows:
//   double  2^-53, one rounding;
//   pair    2^-103: the sum is Dekker's accurate one, 3 u^2 + O(u^3) (Joldes, Muller, Popescu 2017, algorithm 6); the
//           product 5 u^2 (Muller, Rideau 2022, of algorithm 10 there), u = 2^-53; with Dekker's splitting in place of
//           a fused operation the product of two doubles is exact as well.
// `difference` subtracts a double from a double: one rounding, and none in the pair.

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;

struct DoubleLanes {
  static constexpr double unit = 0x1p-53;
  V v;
  AXISCERT_INLINE static DoubleLanes of(V x) { return {x}; }
  AXISCERT_INLINE static DoubleLanes difference(V x, V y) { return {hn::Sub(x, y)}; }
  AXISCERT_INLINE V leading() const { return v; }
  AXISCERT_INLINE friend DoubleLanes operator-(const DoubleLanes& a) { return {hn::Neg(a.v)}; }
  AXISCERT_INLINE friend DoubleLanes operator+(const DoubleLanes& a, const DoubleLanes& b) {
    return {hn::Add(a.v, b.v)};
  }
  AXISCERT_INLINE friend DoubleLanes operator-(const DoubleLanes& a, const DoubleLanes& b) {
    return {hn::Sub(a.v, b.v)};
  }
  AXISCERT_INLINE friend DoubleLanes operator*(const DoubleLanes& a, const DoubleLanes& b) {
    return {hn::Mul(a.v, b.v)};
  }
  // Fused if the instruction set can. A cross product is not fused: it has to be zero for one of x and -x.
  AXISCERT_INLINE static DoubleLanes dot(const Vec3<DoubleLanes>& a, const Vec3<DoubleLanes>& b) {
    return {hn::MulAdd(a.z.v, b.z.v, hn::MulAdd(a.y.v, b.y.v, hn::Mul(a.x.v, b.x.v)))};
  }
};

// hi + lo, hi the double nearest to the sum.
struct PairLanes {
  static constexpr double unit = 0x1p-103;
  V hi, lo;
  AXISCERT_INLINE static PairLanes of(V x) { return {x, hn::Zero(D())}; }
  AXISCERT_INLINE static PairLanes difference(V x, V y) { return two_sum(x, hn::Neg(y)); }
  AXISCERT_INLINE V leading() const { return hi; }

  // Exact: x + y = hi + lo.
  AXISCERT_INLINE static PairLanes two_sum(V x, V y) {
    const V sum = hn::Add(x, y), part = hn::Sub(sum, x);
    return {sum, hn::Add(hn::Sub(x, hn::Sub(sum, part)), hn::Sub(y, part))};
  }
  // Exact where |x| >= |y| or x = 0.
  AXISCERT_INLINE static PairLanes fast_two_sum(V x, V y) {
    const V sum = hn::Add(x, y);
    return {sum, hn::Sub(y, hn::Sub(sum, x))};
  }
  // Exact, within the range that exact/sphere_triangle/oracles/margins-inl.h requires.
  AXISCERT_INLINE static PairLanes two_product(V x, V y) {
    const V product = hn::Mul(x, y);
#if HWY_NATIVE_FMA
    return {product, hn::MulSub(x, y, product)};
#else
    const auto [xh, xl] = split(x);
    const auto [yh, yl] = split(y);
    const V low =
        hn::Add(hn::Add(hn::Add(hn::Sub(hn::Mul(xh, yh), product), hn::Mul(xh, yl)), hn::Mul(xl, yh)), hn::Mul(xl, yl));
    return {product, low};
#endif
  }

  AXISCERT_INLINE friend PairLanes operator+(const PairLanes& a, const PairLanes& b) {
    const PairLanes s = two_sum(a.hi, b.hi), t = two_sum(a.lo, b.lo);
    const PairLanes v = fast_two_sum(s.hi, hn::Add(s.lo, t.hi));
    return fast_two_sum(v.hi, hn::Add(t.lo, v.lo));
  }
  AXISCERT_INLINE friend PairLanes operator-(const PairLanes& a) { return {hn::Neg(a.hi), hn::Neg(a.lo)}; }
  AXISCERT_INLINE friend PairLanes operator-(const PairLanes& a, const PairLanes& b) { return a + -b; }
  AXISCERT_INLINE friend PairLanes operator*(const PairLanes& a, const PairLanes& b) {
    const PairLanes c = two_product(a.hi, b.hi);
    const V low = hn::Add(hn::Mul(a.hi, b.lo), hn::Mul(a.lo, b.hi));
    return fast_two_sum(c.hi, hn::Add(c.lo, low));
  }

 private:
  // x = hi + lo, 26 bits each (Veltkamp).
  AXISCERT_INLINE static PairLanes split(V x) {
    const V scaled = hn::Mul(x, hn::Set(D(), 134217729.0));  // 2^27 + 1
    const V hi = hn::Sub(scaled, hn::Sub(scaled, x));
    return {hi, hn::Sub(x, hi)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
