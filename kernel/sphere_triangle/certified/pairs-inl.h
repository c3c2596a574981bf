// Pairs of doubles, hi + lo, where hi is the double nearest to the sum. No include guard: included once for each of
// Highway's instruction sets, after coarse_step-inl.h.
//
// The errors of the operations, in u^2 = 2^-106 and without terms of u^3, for operands whose lo is at most u of hi:
//   x y        the rounded products hi lo' and lo hi' 1 each, the sums with the error of hi hi' 2 and 3, lo lo' 1:
//              8 |x y| without fused multiply-add, 6 with
//   x.y        8 of each product; the low parts' sums (3 + 3 + 2 + 5) of their sizes' sum: 21 sum |x_i y_i|
//   x y' - y x'  8 of each product, 3 + 4: 15 (|x y'| + |y x'|)
//   x - y      1 of each size for their low parts, 2 for what the sum rounded and these: 4 (|x| + |y|)
// The derivation of the bounds (exact/sphere_triangle/oracles/margins-inl.h) allows U for each of x y and x - y, 3 U
// for each product of x.y, 2 U for each of the third line, and U for a leaf, which is exact here: U = 2^-102 is at
// least twice as much.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
struct Pairs {
  using V = hn::Vec<D>;
  static constexpr double unit = 0x1p-102;
  V hi, lo;

  AXISCERT_INLINE V leading() const { return hi; }
  AXISCERT_INLINE Pairs zero_where(hn::Mask<D> mask) const {
    return {hn::IfThenZeroElse(mask, hi), hn::IfThenZeroElse(mask, lo)};
  }

  // Exact: x + y = hi + lo.
  AXISCERT_INLINE static Pairs two_sum(V x, V y) {
    const V sum = hn::Add(x, y), part = hn::Sub(sum, x);
    return {sum, hn::Add(hn::Sub(x, hn::Sub(sum, part)), hn::Sub(y, part))};
  }
  // Exact unless a part underflows.
  AXISCERT_INLINE static Pairs two_product(V x, V y) {
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
  AXISCERT_INLINE static Pairs difference(V x, V y) { return two_sum(x, hn::Neg(y)); }
  AXISCERT_INLINE static Pairs square(V x) { return two_product(x, x); }

  AXISCERT_INLINE friend Pairs operator-(const Pairs& x, const Pairs& y) {
    const Pairs s = difference(x.hi, y.hi);
    return two_sum(s.hi, hn::Add(hn::Sub(x.lo, y.lo), s.lo));
  }
  AXISCERT_INLINE friend Pairs operator*(const Pairs& x, const Pairs& y) {
    const Pairs p = rough_product(x, y);
    return two_sum(p.hi, p.lo);
  }
  AXISCERT_INLINE static Pairs dot(const Vec3<Pairs>& x, const Vec3<Pairs>& y) {
    const Pairs p = rough_product(x.x, y.x), q = rough_product(x.y, y.y), r = rough_product(x.z, y.z);
    const Pairs s = two_sum(p.hi, q.hi), t = two_sum(s.hi, r.hi);
    return two_sum(t.hi, hn::Add(hn::Add(hn::Add(p.lo, q.lo), r.lo), hn::Add(s.lo, t.lo)));
  }
  AXISCERT_INLINE static Vec3<Pairs> cross(const Vec3<Pairs>& x, const Vec3<Pairs>& y) {
    return {minor(x.y, y.z, x.z, y.y), minor(x.z, y.x, x.x, y.z), minor(x.x, y.y, x.y, y.x)};
  }

 private:
  // hi need not be the double nearest to the sum.
  AXISCERT_INLINE static Pairs rough_product(const Pairs& x, const Pairs& y) {
    const Pairs p = two_product(x.hi, y.hi);
    return {p.hi, hn::MulAdd(x.hi, y.lo, hn::MulAdd(x.lo, y.hi, p.lo))};
  }
  AXISCERT_INLINE static Pairs minor(const Pairs& a, const Pairs& d, const Pairs& b, const Pairs& c) {
    const Pairs p = rough_product(a, d), q = rough_product(b, c), s = difference(p.hi, q.hi);
    return two_sum(s.hi, hn::Add(hn::Sub(p.lo, q.lo), s.lo));
  }
  // x = hi + lo with 26 bits each (Veltkamp).
  AXISCERT_INLINE static Pairs split(V x) {
    const V scaled = hn::Mul(x, hn::Set(D(), 134217729.0));  // 2^27 + 1
    const V hi = hn::Sub(scaled, hn::Sub(scaled, x));
    return {hi, hn::Sub(x, hi)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
