// Scales queries of binary64 that are outside the fine step's range. No include guard: included once for each of
// Highway's instruction sets, after coarse_step-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Queries times the power of two that brings their greatest number between 1 and 2.
template <class D>
struct ScaledToRange {
  using V = hn::Vec<D>;
  V number[13];
  // The greatest number was far from 1 before, the power of two and its inverse are normal numbers, and no number has
  // lost a bit: an inexact product does not give its number back (proofs/coq/certified/Scaling.v).
  hn::Mask<D> useful;

  AXISCERT_INLINE ScaledToRange(D d, const Problem<Lanes<D>>& q)
      : number{q.a.x.v, q.a.y.v, q.a.z.v, q.b.x.v, q.b.y.v, q.b.z.v, q.c.x.v,
               q.c.y.v, q.c.z.v, q.p.x.v, q.p.y.v, q.p.z.v, q.r.v} {
    const hn::RebindToUnsigned<D> words;
    V greatest = hn::Abs(number[0]);
    for (int k = 1; k < 13; ++k) greatest = hn::Max(greatest, hn::Abs(number[k]));
    const auto below = [&](double x) HWY_ATTR { return hn::Lt(greatest, hn::Set(d, x)); };
    const auto from = [&](double x) HWY_ATTR { return hn::Le(hn::Set(d, x), greatest); };
    useful = hn::And(hn::Or(below(0x1p-60), from(0x1p61)), hn::And(from(0x1p-1022), below(0x1p1023)));
    if (hn::AllFalse(d, useful)) return;
    const auto exponent = hn::And(hn::BitCast(words, greatest), hn::Set(words, 0x7ff0'0000'0000'0000));
    const V up = hn::BitCast(d, exponent);
    const V down = hn::BitCast(d, hn::Sub(hn::Set(words, std::uint64_t{2 * 1023} << 52), exponent));
    for (V& x : number) {
      const V scaled = hn::Mul(x, down);
      useful = hn::And(useful, hn::Eq(hn::Mul(scaled, up), x));
      x = scaled;
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
