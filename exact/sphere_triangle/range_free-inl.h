// Number types of R-infinity over Highway vectors of doubles, one query per lane, and the pass over a batch. No guard:
// included once for each of Highway's instruction sets.
HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;
using Words = hn::RebindToUnsigned<D>;

AXISCERT_INLINE V constant(double x) { return hn::Set(D(), x); }
AXISCERT_INLINE hn::Vec<Words> words_of(V x) { return hn::BitCast(Words(), x); }
AXISCERT_INLINE hn::Vec<Words> word(std::uint64_t x) { return hn::Set(Words(), x); }
AXISCERT_INLINE V number_of(hn::Vec<Words> x) { return hn::BitCast(D(), x); }

// 24 bits per lane: the vector form of exact/sphere_triangle/wide_range_float.h, which has the proof.
struct WideRangeLanes {
  V v;

  AXISCERT_INLINE static WideRangeLanes of(V x) { return {x}; }
  // A number with the sign of a - b: binary64 subtracts with gradual underflow, so the result is 0 only for equal
  // operands.
  AXISCERT_INLINE static V difference_sign(const WideRangeLanes& a, const WideRangeLanes& b) {
    return hn::Sub(a.v, b.v);
  }
  AXISCERT_INLINE friend WideRangeLanes operator+(const WideRangeLanes& a, const WideRangeLanes& b) {
    return rounded(hn::Add(a.v, b.v));
  }
  AXISCERT_INLINE friend WideRangeLanes operator-(const WideRangeLanes& a, const WideRangeLanes& b) {
    return rounded(hn::Sub(a.v, b.v));
  }
  AXISCERT_INLINE friend WideRangeLanes operator*(const WideRangeLanes& a, const WideRangeLanes& b) {
    return rounded(hn::Mul(a.v, b.v));
  }

 private:
  AXISCERT_INLINE static WideRangeLanes rounded(V x) {
    constexpr int dropped = 53 - 24;
    constexpr std::uint64_t unit = std::uint64_t{1} << dropped;
    const auto bits = words_of(x);
    const auto odd = hn::And(hn::ShiftRight<dropped>(bits), word(1));
    const auto carried = hn::Add(hn::Add(bits, word(unit / 2 - 1)), odd);
    return {number_of(hn::And(carried, word(~(unit - 1))))};
  }
};

// 53 bits and an exponent of its own: m 2^e, 1 <= |m| < 2 and e a whole number; 0 is m = 0 with e = -2^40 or less.
// Every operation gives its exact result rounded once to 53 bits, nearest even, as long as the exponents of numbers
// that are not 0 stay within +-2^30, and numbers of degree 6 stay within +-2^13.
//
// A product of the two m has a magnitude in [1, 4) and is rounded there, where binary64 has 53 bits.
// In a sum let a have the greater exponent. Both m are scaled to that exponent: |m_a| is in [1, 2), and m_b is divided
// by 2^d, which is exact as long as d <= 200, and so the sum is rounded once, to 0 or to a magnitude in [2^-252, 4).
// Beyond, m_b is divided by 2^200 in place of 2^d: either way the sum is m_a and a number that is not 0, is smaller
// than 2^-199 and has the same sign, and as m_a's neighbours are 2^-53 away or more both are rounded to m_a. A 0 has
// m_b = 0 and changes nothing.
struct WideExponentLanes {
  V m, e;

  // Converts any finite numbers: those below 2^-900 are multiplied by 2^200, exactly, so that none is subnormal.
  AXISCERT_INLINE static WideExponentLanes of(V x) {
    const auto small = hn::Lt(hn::Abs(x), constant(0x1p-900));
    return normalised(hn::IfThenElse(small, hn::Mul(x, constant(0x1p200)), x),
                      hn::IfThenElseZero(small, constant(-200)));
  }
  AXISCERT_INLINE static V difference_sign(const WideExponentLanes& a, const WideExponentLanes& b) {
    return sum(a, hn::Neg(b.m), b.e, hn::Max(a.e, b.e));
  }
  AXISCERT_INLINE friend WideExponentLanes operator+(const WideExponentLanes& a, const WideExponentLanes& b) {
    const V top = hn::Max(a.e, b.e);
    return normalised(sum(a, b.m, b.e, top), top);
  }
  AXISCERT_INLINE friend WideExponentLanes operator-(const WideExponentLanes& a, const WideExponentLanes& b) {
    const V top = hn::Max(a.e, b.e);
    return normalised(sum(a, hn::Neg(b.m), b.e, top), top);
  }
  AXISCERT_INLINE friend WideExponentLanes operator*(const WideExponentLanes& a, const WideExponentLanes& b) {
    return normalised(hn::Mul(a.m, b.m), hn::Add(a.e, b.e));
  }

 private:
  AXISCERT_INLINE static V sum(const WideExponentLanes& a, V m, V e, V top) {
    return hn::Add(hn::Mul(a.m, power(hn::Sub(a.e, top))), hn::Mul(m, power(hn::Sub(e, top))));
  }
  // 2^d for a whole d <= 0, but 2^-200 at least. In [2^52, 2^53) a double's last bits are those of its integer.
  AXISCERT_INLINE static V power(V d) {
    const V biased = hn::Add(hn::Max(d, constant(-200)), constant(0x1p52 + 1023));
    return number_of(hn::ShiftLeft<52>(words_of(biased)));
  }
  // m 2^e; requires that |m| is normal or 0.
  AXISCERT_INLINE static WideExponentLanes normalised(V m, V e) {
    constexpr std::uint64_t exponent = std::uint64_t{0x7ff} << 52;
    const auto bits = words_of(m);
    const auto biased = hn::ShiftRight<52>(hn::And(bits, word(exponent)));
    const V shift = hn::Sub(number_of(hn::Or(biased, words_of(constant(0x1p52)))), constant(0x1p52 + 1023));
    const V one = number_of(hn::Or(hn::AndNot(word(exponent), bits), words_of(constant(1))));
    const auto zero = hn::Eq(m, hn::Zero(D()));
    return {hn::IfThenZeroElse(zero, one), hn::IfThenElse(zero, constant(-0x1p40), hn::Add(e, shift))};
  }
};

AXISCERT_INLINE V load_wide(const float* from) {
  const hn::Rebind<float, D> half;
  return hn::PromoteTo(D(), hn::LoadU(half, from));
}
AXISCERT_INLINE V load_wide(const double* from) { return hn::LoadU(D(), from); }

template <class Real>
using RangeFree = std::conditional_t<sizeof(Real) == 4, WideRangeLanes, WideExponentLanes>;

template <Strictness strictness>
struct RangeFreeSink {
  hn::Vec<Words> words;

  template <class T>
  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const V sign = T::difference_sign(lhs, rhs), zero = hn::Zero(D());
    const bool nonstrict = strictness == Strictness::nonstrict && !info(which).is_radius;
    const auto held = nonstrict ? hn::Ge(sign, zero) : hn::Gt(sign, zero);
    const auto bit = word(one_bit<std::uint64_t>(which));
    words = hn::Or(words, words_of(hn::IfThenElseZero(held, number_of(bit))));
  }
};

template <class F, class Real, Strictness strictness>
void range_free_bits(const QueryColumns<Real>& batch, ComparisonBits* out) {
  using T = RangeFree<Real>;
  constexpr std::size_t lanes = hn::MaxLanes(D());
  for_each_vector<Real, lanes>(
      batch, [out](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count) HWY_ATTR {
        const auto number = [&](std::size_t k) HWY_ATTR { return T::of(load_wide(from.column[k] + at)); };
        const auto vec = [&](std::size_t k) HWY_ATTR { return Vec3<T>{number(k), number(k + 1), number(k + 2)}; };
        RangeFreeSink<strictness> sink{hn::Zero(Words())};
        F::comparisons(Problem<T>{vec(0), vec(3), vec(6), vec(9), number(12), T::of(hn::Zero(D()))}, sink);
        std::uint64_t each[lanes];
        hn::StoreU(sink.words, Words(), each);
        for (std::size_t j = 0; j < count; ++j) out[i + j] = static_cast<ComparisonBits>(each[j]);
      });
}

template <class F, class Real>
RangeFreeForms<Real> range_free_forms() {
  return {range_free_bits<F, Real, Strictness::strict>, range_free_bits<F, Real, Strictness::nonstrict>};
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
