// The conservative test: separated only where that is certain, without a second step. No include guard: included once
// for each of Highway's instruction sets, after coarse_step-inl.h. Not fused, so that all instruction sets answer
// alike.
//
// A vector n separates iff n.X > r |n| for X = A, B, C. Four vectors are tried: the point of each edge nearest to the
// centre, and V = AB x AC. Below A, B, C are the translated vertices as computed, each within u |A| of the exact one; M
// = max(|A|, |B|, |C|), W = max(A.A, B.B, C.C, rr), and u as in thresholds.h.
//
// An edge AB. s is A.BA / |AB|^2 as computed, clamped to [0, 1], and n = (1 - s) A + s B for that very s. From the six
// dot products of A, B, C, off by 3.1 u M^2 each, come n.A = A.A + s (A.B - A.A), and so on, off by 8.2 u M^2, and n.n
// = n.A + s (n.B - n.A), off by 13.3 u M^2: the exact values are convex combinations, and |A.B - A.A| <= 2 M^2 rounds
// twice.
//
// Never a missed contact (proofs/coq/certified/Conservative.v; its constants come from there). The exact vertices
// separate if n.X > (r + u M) |n| for the computed ones.
//   edge   m = min n.X^ - 10 u W is at most the exact one. It passes where m > 0 and m^2 > R (n.n^ + 18 u W), with
//          R = rr + 18 u W: R >= (r + u M)^2, for 2 r u M <= 2 u W; n.n^ + 18 u W >= n.n (1 + 3 u), which the products
//          lose.
//   plane  n is what was stored, n.X^ >= computed - 3.1 u |n| M. It passes where m = min n.X^ > 0 and m^2 > R n.n^:
//          after the roundings of m^2, n.n and R (7 u) that is m^2 > (rr + 10.6 u W) n.n >= ((r + 4.1 u M) |n|)^2.
// The constants used are a sixteenth greater, which covers the terms of u^2.
//
// Phantom depth. Let L = max(M, r), so that W <= L^2, and rho > r + x sqrt u L the distance.
//   nearest is on an edge
//          A.AB is off by 4.1 u |A| |AB|, |AB|^2 by 5.1 u |AB|^2: n is d, at most 16.5 u M long, from the nearest point
//          n*, along the edge. n*.X >= rho^2 for every X of the triangle and n*.d >= 0, so n.X >= rho^2 - 33 u M^2,
//          m >= rho^2 - 52.5 u W; and n.n <= rho^2 + 33.1 u W. It passes where
//          (rho^2 - 52.5 u W)^2 > (rr + 21 u W) (rho^2 + 65 u W) (1 + 3 u), for which
//          rho^2 (rho^2 - rr) > 194.1 u W rho^2 + 1400 u^2 W^2 is enough: x >= 14.25.
//   within the face
//          |V^ - V| <= 5.66 u |AB| |CA|. Where |V| >= sqrt u |AB| |CA|, n = V^ has n.X / |n| >= rho - 11.4 sqrt u M,
//          and passes above r + 4.3 sqrt u L: x >= 15.7. Otherwise the triangle lies within 2 sqrt u M of its longest
//          edge, whose n has lost that much more: x >= 16.25.
// The stated bound is x = 20, which proofs/coq/certified/PhantomStep.v proves. Values below the ranges, V of 2^-30 W
// (2^-60 W) or an edge whose square underflows, mean a triangle within 2^-14 M (2^-29 M) of an edge or a vertex: 0.4 of
// x at most.
//
// Range: W in [2^-42, 2^60] (binary64: 2^-400, 2^400). V is scaled by the power of two below 1 / W, so that |V| <= 8;
// then every product compared is at least 18 u W 2^-60 (2^-120), a normal number, and below 2^122. Underflow in a dot
// product is below 2^-140 (2^-1060), which the constants cover. The quotient of a very short edge may overflow: an
// infinity is clamped to 0 or 1. Nothing else does, for any thirteen numbers
// (proofs/coq/certified/ConservativeFloat.v).
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
struct Conservative {
  using T = Lanes<D, false>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Real = hn::TFromD<D>;
  using Bits = hn::RebindToUnsigned<D>;
  using Bounds = filter::ConservativeBounds;
  static constexpr bool is_float = sizeof(Real) == 4;

  AXISCERT_INLINE static V constant(double x) { return hn::Set(D(), static_cast<Real>(x)); }
  AXISCERT_INLINE static T units(double n) { return {constant(n * static_cast<double>(unit_roundoff<Real>))}; }
  AXISCERT_INLINE static V greatest(const Vec3<T>& v) {
    return hn::Max(hn::Max(hn::Abs(v.x.v), hn::Abs(v.y.v)), hn::Abs(v.z.v));
  }
  AXISCERT_INLINE static void scale(Vec3<T>& v, V by) {
    v = {{hn::Mul(v.x.v, by)}, {hn::Mul(v.y.v, by)}, {hn::Mul(v.z.v, by)}};
  }
  // 2^-e for x in [2^e, 2^(e + 1)); x is at least the least normal number and below 2^127 (2^1023).
  AXISCERT_INLINE static V inverse_power(V x) {
    using Word = hn::TFromD<Bits>;
    constexpr Word exponent = is_float ? Word{0x7f800000u} : static_cast<Word>(0x7ff0000000000000ull);
    constexpr Word twice_bias = is_float ? Word{0x7f000000u} : static_cast<Word>(0x7fe0000000000000ull);
    const Bits words;
    return hn::BitCast(D(),
                       hn::Sub(hn::Set(words, twice_bias), hn::And(hn::BitCast(words, x), hn::Set(words, exponent))));
  }

  // unknown: W is outside the range, a number is not finite, or r is negative.
  struct Answer {
    M separated, unknown;
  };

  AXISCERT_INLINE static Answer answer(const Problem<T>& q) {
    return of_centred(q.a - q.p, q.b - q.p, q.c - q.p, q.r, hn::Ge(q.r.v, hn::Zero(D())));
  }

  // The same after scaling the greatest component of A, B, C and r to [1, 2), for any size. unknown: the query is
  // invalid, or a difference (nearly) overflows.
  AXISCERT_INLINE static Answer answer_scaled(const Problem<T>& q) {
    Vec3<T> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p;
    T r = q.r;
    const auto largest = [&]()
                             HWY_ATTR { return hn::Max(hn::Max(greatest(A), greatest(B)), hn::Max(greatest(C), r.v)); };
    const auto scale_all = [&](V by) HWY_ATTR {
      for (Vec3<T>* v : {&A, &B, &C}) scale(*v, by);
      r.v = hn::Mul(r.v, by);
    };
    V size = largest();
    // A subnormal size has no exponent to read, so it is scaled up first.
    const V small = constant(is_float ? 0x1p-100 : 0x1p-900);
    scale_all(hn::IfThenElse(hn::Lt(size, small), constant(is_float ? 0x1p64 : 0x1p128), constant(1)));
    size = largest();
    // The lower limit is for size 0: all vertices on the centre and r = 0, which is a contact.
    scale_all(inverse_power(hn::Max(size, constant(is_float ? 0x1p-120 : 0x1p-1000))));
    const auto is_good = hn::And(hn::Ge(q.r.v, hn::Zero(D())), hn::Lt(size, constant(is_float ? 0x1p126 : 0x1p1022)));
    Answer found = of_centred(A, B, C, r, is_good);
    found.unknown = hn::AndNot(hn::And(hn::Eq(squares(A, B, C, r).v, hn::Zero(D())), is_good), found.unknown);
    return found;
  }

 private:
  // The sum of squares, which is NaN if any number is; the greatest of them might hide it.
  AXISCERT_INLINE static T squares(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const T& r) {
    return ((dot(A, A) + dot(B, B)) + dot(C, C)) + r * r;
  }

  AXISCERT_INLINE static Answer of_centred(const Vec3<T>& A, const Vec3<T>& B, const Vec3<T>& C, const T& r,
                                           M is_good) {
    const D d;
    const T aa = dot(A, A), bb = dot(B, B), cc = dot(C, C), ab = dot(A, B), bc = dot(B, C), ca = dot(C, A);
    const T rr = r * r;
    const T W{hn::Max(hn::Max(aa.v, bb.v), hn::Max(cc.v, rr.v))};
    const T error = units(Bounds::error) * W, square_error = units(Bounds::square_error) * W, R = rr + square_error;

    M separated = hn::MaskFromVec(hn::Zero(d));
    const auto try_axis = [&](const T& m, const T& square, M usable) HWY_ATTR {
      const auto passes = hn::And(hn::Gt(m.v, hn::Zero(d)), hn::Gt((m * m).v, (R * square).v));
      separated = hn::Or(separated, hn::And(usable, passes));
    };
    const auto everywhere = hn::Eq(hn::Zero(d), hn::Zero(d));
    const auto least_of = [](const T& x, const T& y, const T& z)
                              HWY_ATTR { return T{hn::Min(hn::Min(x.v, y.v), z.v)}; };
    // The edge from X to Y; xz and yz are the dot products with the third vertex.
    const auto edge = [&](const Vec3<T>& X, const Vec3<T>& along, const T& xx, const T& xy, const T& yy, const T& xz,
                          const T& yz) HWY_ATTR {
      const T e = dot(along, along);
      const auto has_length = hn::Gt(e.v, hn::Zero(d));
      const V at = hn::IfThenElseZero(has_length, hn::Div(hn::Neg(dot(X, along).v), e.v));
      const T s{hn::Min(hn::Max(at, hn::Zero(d)), constant(1))};
      const T at_x = xx + s * (xy - xx), at_y = xy + s * (yy - xy), at_z = xz + s * (yz - xz);
      try_axis(least_of(at_x, at_y, at_z) - error, at_x + s * (at_y - at_x) + square_error, everywhere);
    };
    const Vec3<T> AB = B - A, BC = C - B, CA = A - C;
    edge(A, AB, aa, ab, bb, ca, bc);
    edge(B, BC, bb, bc, cc, ab, ca);
    edge(C, CA, cc, ca, aa, bc, ab);

    Vec3<T> normal = cross(CA, AB);
    scale(normal, inverse_power(W.v));
    const T at_a = dot(A, normal), at_b = dot(B, normal), at_c = dot(C, normal), square = dot(normal, normal);
    const T side{hn::CopySignToAbs(constant(1), at_a.v)};  // V or -V, whichever points to the side of A
    try_axis(least_of(side * at_a, side * at_b, side * at_c), square,
             hn::Ge(square.v, constant(is_float ? Bounds::least_normal_binary32 : Bounds::least_normal_binary64)));

    const auto is_known =
        hn::And(is_good,
                hn::And(hn::Ge(W.v, constant(is_float ? Bounds::least_square_binary32 : Bounds::least_square_binary64)),
                        hn::Le(squares(A, B, C, r).v, constant(is_float ? 0x1p60 : 0x1p400))));
    return {hn::And(separated, is_known), hn::Not(is_known)};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
