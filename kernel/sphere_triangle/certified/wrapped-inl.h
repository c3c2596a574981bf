// Integers modulo 2^64, one query per lane: a value known to be below 2^63 in magnitude is known exactly by its
// residue, however large the products in it are. No include guard: included once for each of Highway's instruction
// sets, after pairs-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
struct WrappedWords {
  using Words = hn::RebindToUnsigned<D>;
  using V = hn::Vec<Words>;
  V v;

  AXISCERT_INLINE friend WrappedWords operator+(const WrappedWords& x, const WrappedWords& y) {
    return {hn::Add(x.v, y.v)};
  }
  AXISCERT_INLINE friend WrappedWords operator-(const WrappedWords& x, const WrappedWords& y) {
    return {hn::Sub(x.v, y.v)};
  }
  AXISCERT_INLINE friend WrappedWords operator-(const WrappedWords& x) { return {hn::Sub(hn::Zero(Words()), x.v)}; }
  AXISCERT_INLINE friend WrappedWords operator*(const WrappedWords& x, const WrappedWords& y) {
#if HWY_TARGET == HWY_SCALAR || HWY_TARGET == HWY_EMU128
    return {x.v * y.v};
#else
    // Highway 1.0 has no such product for other vectors; compilers do.
    using Raw = decltype(x.v.raw);
    using Factors [[gnu::vector_size(sizeof(Raw))]] = std::uint64_t;
    return {V{reinterpret_cast<Raw>(reinterpret_cast<Factors>(x.v.raw) * reinterpret_cast<Factors>(y.v.raw))}};
#endif
  }
  // Properties of the integer below 2^63 in magnitude that has this residue modulo 2^64.
  AXISCERT_INLINE hn::Mask<D> is_zero() const { return hn::RebindMask(D(), hn::Eq(v, hn::Zero(Words()))); }
  AXISCERT_INLINE hn::Mask<D> is_negative() const {
    const hn::RebindToSigned<D> integers;
    return hn::RebindMask(D(), hn::Lt(hn::BitCast(integers, v), hn::Zero(integers)));
  }
};
template <class D>
AXISCERT_INLINE hn::Mask<D> is_zero(const Vec3<WrappedWords<D>>& v) {
  return hn::And(v.x.is_zero(), hn::And(v.y.is_zero(), v.z.is_zero()));
}

// The leaves of a comparison and its radius as integers, in units of the least bit that is set in any of them.
template <class D>
class Units {
 public:
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using W = WrappedWords<D>;
  using Leaf = Vec3<Pairs<D>>;

  template <std::size_t n>
  AXISCERT_INLINE Units(D d, const Leaf (&leaves)[n], V r) : d_(d) {
    V greatest = hn::Abs(r), low = hn::Zero(d);
    for (const Leaf& leaf : leaves) {
      for (const Pairs<D>* x : {&leaf.x, &leaf.y, &leaf.z}) {
        greatest = hn::Max(greatest, hn::Abs(x->hi));
        low = hn::Or(low, x->lo);
      }
    }
    has_low_ = !hn::AllTrue(d, hn::Eq(low, hn::Zero(d)));
    // 2^(60 - the exponent of the greatest): all numbers are below 2^61, and a leaf's two parts together below 2^62.
    // This holds for a greatest number in DeepStep's range, and for zeros; for others the results are not used.
    const auto exponent = hn::And(hn::BitCast(Words(), greatest), words(0x7ff0'0000'0000'0000));
    per_unit_ = hn::BitCast(d, hn::Sub(words(std::uint64_t{2 * 1023 + 60} << 52), exponent));
    auto any = integer(r).v;
    radius_is_exact_ = is_integer(r);
    exact_ = hn::Eq(r, r);
    const auto include = [&](V x) HWY_ATTR {
      any = hn::Or(any, integer(x).v);
      exact_ = hn::And(exact_, is_integer(x));
    };
    for (const Leaf& leaf : leaves) {
      for (const Pairs<D>* x : {&leaf.x, &leaf.y, &leaf.z}) include(x->hi);
    }
    if (has_low_) {
      for (const Leaf& leaf : leaves) {
        for (const Pairs<D>* x : {&leaf.x, &leaf.y, &leaf.z}) include(x->lo);
      }
    }
    // Their least set bit, a power of two; it is zero if all are zero.
    const auto least = hn::BitCast(hn::RebindToSigned<D>(), hn::And(any, hn::Sub(words(0), any)));
    const auto reciprocal =
        hn::Sub(words(std::uint64_t{2 * 1023} << 52), hn::BitCast(Words(), hn::ConvertTo(d, least)));
    per_unit_ = hn::Mul(per_unit_, hn::BitCast(d, reciprocal));
  }

  AXISCERT_INLINE W integer(V x) const {
    return {hn::BitCast(Words(), hn::ConvertTo(hn::RebindToSigned<D>(), hn::Mul(x, per_unit_)))};
  }
  AXISCERT_INLINE W integer(const Pairs<D>& x) const {
    return has_low_ ? integer(x.hi) + integer(x.lo) : integer(x.hi);
  }
  AXISCERT_INLINE Vec3<W> integer(const Leaf& leaf) const {
    return {integer(leaf.x), integer(leaf.y), integer(leaf.z)};
  }
  // Lanes in which the residue of a value of this degree determines it, if the value is at most twice `bound` in
  // magnitude and computed from integers.
  template <int degree>
  AXISCERT_INLINE M is_known(V bound) const {
    for (int i = 0; i < degree; ++i) bound = hn::Mul(bound, per_unit_);
    return hn::Le(bound, hn::Set(d_, 0x1p60));
  }
  AXISCERT_INLINE M are_exact() const { return exact_; }
  AXISCERT_INLINE M radius_is_exact() const { return hn::And(exact_, radius_is_exact_); }

 private:
  using Words = typename W::Words;
  AXISCERT_INLINE static hn::Vec<Words> words(std::uint64_t x) { return hn::Set(Words(), x); }
  // The product is exact unless it underflows, to zero or to a value below one.
  AXISCERT_INLINE M is_integer(V x) const {
    const V scaled = hn::Mul(x, per_unit_), zero = hn::Zero(d_);
    return hn::And(hn::Eq(hn::Trunc(scaled), scaled), hn::Or(hn::Ne(scaled, zero), hn::Eq(x, zero)));
  }

  D d_;
  bool has_low_;  // some lane has a low part that is not zero
  V per_unit_;    // number of units in 1: a power of two
  M exact_, radius_is_exact_;
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
