// The conservative test: separated only where that is certain, no second step. No guard: included once for each of
// Highway's instruction sets, after coarse_step-inl.h. Not fused, so that all instruction sets answer alike.
//
// Any vector n separates iff n.X > r |n| for X = A, B, C. Seven are tried: the vertices, the points of the edges' lines
// that are nearest the centre, V = AB x AC. However n was computed, only the rounding of that comparison matters to
// never missing a contact. Everything is first scaled by a power of two that brings the greatest component of A, B, C
// and r to [1, 2); s = max(|A|, |B|, |C|), S as in thresholds.h, u likewise.
//
// Never a missed contact. n is what was stored, n.X^ >= computed - 4 u |n| s, and the computed m = min n.X^ passes
// where m > 0, m^2 > R2 n.n with R2 = rr + 18 u S: over the reals m > |n| sqrt(R2 (1 - 13 u)), since m^2, n.n (3 u), R2
// (8 u) and the product round. And R2 (1 - 13 u) >= (r + 4 u s)^2, because 13 u rr + 8 u r s + 16 u^2 s^2 <= 17.1 u S.
// Where n.n is below least_square_of_axis the axis is not used, so that R2 n.n >= 2^-20 least_square_of_axis is normal;
// what underflows in n.X is below 2^-140 (2^-1060) and inside the constant.
//
// Phantom depth. Let M = max(|A|, |B|, |C|, r), the distance rho > r + D M, and g = min n.X / |n| over the reals. n
// passes where g >= r + sqrt(33 u S) + 4 u M, and S <= 4 M^2: where g >= rho - (D - 11.5 sqrt u) M, but for 4 u.
//   nearest is a vertex        n = that vertex: g >= rho - 2 u M
//   within an edge             n = A + t AB, off by 28 u M at most: A.AB by 5 u |A| |AB|, so t by 5 u |A| / |AB| + 7 u,
//                              and 3 u (|A| + |AB|) more, |AB| <= 2 M. g >= rho - 28 u M^2 / rho - 28 u M
//   within the face            |V^ - V| <= 5.66 u |AB| |CA|. Where |V| >= q |AB| |CA|, n = V: g >= rho - 11.4 (u / q)
//   M.
//                              Otherwise the triangle lies within 2 q M of its longest edge, and the n that belongs to
//                              the point of that edge nearest the centre has g >= rho - 2 q M - the loss above. With
//                              q = sqrt(5.7 u) both are 4.8 sqrt u M.
// So D = x sqrt u is enough where x >= 11.5 + 4.8 + 28 / x: x = 18; stated is 20. What is below the range, an edge of
// 2^-50 M or |V| < sqrt(least_square_of_axis), moves a point by 2^-25 M (2^-100 M) at most; inside the 2 that are left.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
struct Conservative {
  using T = Lanes<D, false>;
  using V = hn::Vec<D>;
  using Real = hn::TFromD<D>;
  using Bits = hn::RebindToUnsigned<D>;
  static constexpr bool is_float = sizeof(Real) == 4;
  static constexpr Real least_square_of_axis = is_float ? static_cast<Real>(0x1p-100) : static_cast<Real>(0x1p-400);

  AXISCERT_INLINE static V constant(double x) { return hn::Set(D(), static_cast<Real>(x)); }
  AXISCERT_INLINE static V greatest(const Vec3<T>& v) {
    return hn::Max(hn::Max(hn::Abs(v.x.v), hn::Abs(v.y.v)), hn::Abs(v.z.v));
  }
  AXISCERT_INLINE static void scale(Vec3<T>& v, V by) {
    v = {{hn::Mul(v.x.v, by)}, {hn::Mul(v.y.v, by)}, {hn::Mul(v.z.v, by)}};
  }
  // 2^-e for x in [2^e, 2^(e + 1)), x at least the least normal number and below 2^127 (2^1023).
  AXISCERT_INLINE static V inverse_power(V x) {
    using Word = hn::TFromD<Bits>;
    constexpr Word exponent = is_float ? Word{0x7f800000u} : static_cast<Word>(0x7ff0000000000000ull);
    constexpr Word twice_bias = is_float ? Word{0x7f000000u} : static_cast<Word>(0x7fe0000000000000ull);
    const Bits words;
    return hn::BitCast(D(),
                       hn::Sub(hn::Set(words, twice_bias), hn::And(hn::BitCast(words, x), hn::Set(words, exponent))));
  }

  struct Answer {
    hn::Mask<D> separated,
        unknown;  // unknown: a number that is not finite or negative, or a difference that (nearly) overflows
  };

  AXISCERT_INLINE static Answer answer(D d, const Problem<T>& q) {
    Vec3<T> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p;
    Vec3<T> AB = q.b - q.a, BC = q.c - q.b, CA = q.a - q.c;
    T r = q.r;
    const auto largest = [&]()
                             HWY_ATTR { return hn::Max(hn::Max(greatest(A), greatest(B)), hn::Max(greatest(C), r.v)); };
    const auto scale_all = [&](V by) HWY_ATTR {
      for (Vec3<T>* v : {&A, &B, &C, &AB, &BC, &CA}) scale(*v, by);
      r.v = hn::Mul(r.v, by);
    };
    V size = largest();
    const V small = constant(is_float ? 0x1p-100 : 0x1p-900);
    if (!hn::AllFalse(d, hn::Lt(size, small))) {  // subnormal sizes have no exponent to read
      scale_all(hn::IfThenElse(hn::Lt(size, small), constant(is_float ? 0x1p64 : 0x1p128), constant(1)));
      size = largest();
    }
    scale_all(inverse_power(size));

    const T aa = dot(A, A), bb = dot(B, B), cc = dot(C, C), ab = dot(A, B), bc = dot(B, C), ca = dot(C, A);
    const T rr = r * r, S = ((aa + bb) + cc) + rr;
    const T R2 = rr + T{constant(18 * (1 + 0x1p-4) * static_cast<double>(unit_roundoff<Real>))} * S;

    hn::Mask<D> separated = hn::MaskFromVec(hn::Zero(d));
    const auto try_axis = [&](const T& square, const T& at_a, const T& at_b, const T& at_c) HWY_ATTR {
      const T m{hn::Min(hn::Min(at_a.v, at_b.v), at_c.v)};
      const auto in_range = hn::And(hn::Gt(m.v, hn::Zero(d)), hn::Ge(square.v, hn::Set(d, least_square_of_axis)));
      separated = hn::Or(separated, hn::And(in_range, hn::Gt((m * m).v, (R2 * square).v)));
    };
    try_axis(aa, aa, ab, ca);
    try_axis(bb, ab, bb, bc);
    try_axis(cc, ca, bc, cc);
    const auto edge = [&](const Vec3<T>& from, const Vec3<T>& along) HWY_ATTR {
      const T t{hn::Div(dot(from, along).v, dot(along, along).v)};  // 0/0 is NaN, and no axis
      const Vec3<T> n = from - along * t;
      try_axis(dot(n, n), dot(n, A), dot(n, B), dot(n, C));
    };
    edge(A, AB);
    edge(B, BC);
    edge(C, CA);
    const Vec3<T> normal = cross(CA, AB);
    const T side{hn::CopySignToAbs(constant(1), dot(A, normal).v)};  // V or -V, whichever A lies beyond
    try_axis(dot(normal, normal), side * dot(A, normal), side * dot(B, normal), side * dot(C, normal));

    const auto is_known = hn::And(hn::And(hn::Lt(S.v, constant(64)), hn::Ge(q.r.v, hn::Zero(d))),
                                  hn::Lt(size, constant(is_float ? 0x1p126 : 0x1p1022)));
    return {hn::And(separated, is_known), hn::Not(is_known)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
