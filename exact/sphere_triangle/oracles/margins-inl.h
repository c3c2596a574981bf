// The sixteen margins with bounds of their errors, over the number types of numbers-inl.h. No guard: included once for
// each of Highway's instruction sets.
//
// The derivation. U is the number type's unit, hats are computed values. A leaf, one of the six vectors A - P, B - P, C
// - P, B - A, C - B, A - C, is a difference of two inputs: (1 + U) of the exact one in each component, whatever the
// exponents. |x|o is the greatest component of a leaf, |x|1 the sum of the three. To first order in U,
// clang-format off
//   x.y          two leaves, a product, two sums   |error| <= 5 U sum |x_i y_i| <= 15 U |x|o |y|o;  of x.x 5 U x.x
//   N = A x AB   4 U for each of two products      each component errs by nu = 8 U |A|o |AB|o at most
//   V = AB x AC  the same                          omega = 8 U |AB|o |AC|o; V = 0 exactly where B = C
//   |N|^2        from the components               2 nu |N^|1 + 3 nu^2 + 3 U |N^|^2
//   d = A.V      from V, and a product of leaves   |A|o (3 omega + 4 U |V^|1) =: delta
// clang-format on
// and from these the bound beside each margin below. U is taken 1/16 greater: that covers the second order (U <= 2^-53,
// chains of fewer than 20 operations), the rounding of the bounds themselves (relative 2^-48), a pair's leading double
// in place of the pair (2^-53).
//
// Range. binary32 in double: the inputs are multiples of 2^-149 below 2^128, so each value of degree k that is formed
// is a multiple of 2^(-149 k), rounding keeps it one, and no value has a degree above 6: zero or at least 2^-894, below
// 2^800. The smallest product in a bound, rr 3 omega^2, is at least 2^-298 (2^-50 2^-298)^2 = 2^-994. Nothing
// underflows, nothing overflows.
// binary64, in doubles or in pairs: a lane counts if |A|o, |B|o, |C|o, |AB|o, |BC|o, |CA|o and r are each zero or in
// [2^-100, 2^100]. Then no value leaves 2^620. A product errs by an additional 2^-1070 at most if it, or its low part,
// underflows. The corresponding term of a bound is 2^-800 or more, or it is zero together with a leaf, all of whose
// products are exact zeros: such errors are below 2^-200 of the bound, and inside its sixteenth.
//
// The constants are MarginBounds of proofs/coq/certified/Margins.v, which proves that each bound exceeds its margin's
// error by a thirty-second part if each operation has a relative error of at most U; that thirty-second covers the
// bound's own rounding. The absence of underflow and the bounds of the scales are argued here only.
//
// So a margin that exceeds its bound has the sign of the exact one; and if the bound is zero, all of its operands are
// exact zeros, the margin is exact, and a tie is certain.
#include "kernel/sphere_triangle/forms/margin_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
using filter::MarginBounds;

// A batch's numbers as double lanes.
struct RawQuery {
  Vec3<V> a, b, c, p;
  V r;
};

template <class T>
struct Leaf {
  Vec3<T> v;
  V norm;  // the greatest component

  AXISCERT_INLINE Leaf(const Vec3<V>& from, const Vec3<V>& to)
      : v{T::difference(to.x, from.x), T::difference(to.y, from.y), T::difference(to.z, from.z)},
        norm(hn::Max(hn::Max(hn::Abs(v.x.leading()), hn::Abs(v.y.leading())), hn::Abs(v.z.leading()))) {}
};

template <class T>
AXISCERT_INLINE V absolute_sum(const Vec3<T>& v) {
  return hn::Add(hn::Add(hn::Abs(v.x.leading()), hn::Abs(v.y.leading())), hn::Abs(v.z.leading()));
}

// A margin lhs - rhs, |error| <= bound; and |lhs| + |rhs|, |error| <= scale_bound.
template <class T>
struct Margin {
  T value;
  V bound, scale, scale_bound;
};

// The form whose sides the scale measures; the signs are the same in both.
enum class EdgeForm { published, reduced };

// Multiples of U, each a sixteenth greater; and sums and products of bounds.
template <class T>
AXISCERT_INLINE V units(double n) {
  return hn::Set(D(), n * T::unit * MarginBounds::unit_factor);
}
AXISCERT_INLINE V times(V x, V y) { return hn::Mul(x, y); }
AXISCERT_INLINE V plus(V x, V y) { return hn::Add(x, y); }
AXISCERT_INLINE V times_plus(V x, V y, V z) { return hn::MulAdd(x, y, z); }
AXISCERT_INLINE V constant(double x) { return hn::Set(D(), x); }

// Emits all sixteen margins, in no promised order, as emit(which, margin).
template <EdgeForm form, class T>
struct Margins {
  Leaf<T> a, b, c, ab, bc, ca;
  T rr;
  V r;

  AXISCERT_INLINE explicit Margins(const RawQuery& q)
      : a(q.p, q.a),
        b(q.p, q.b),
        c(q.p, q.c),
        ab(q.a, q.b),
        bc(q.b, q.c),
        ca(q.c, q.a),
        rr(T::of(q.r) * T::of(q.r)),
        r(q.r) {}

  // Within binary64's range: each zero or in [2^-100, 2^100].
  AXISCERT_INLINE M in_range() const {
    const V least = constant(0x1p-100), greatest = constant(0x1p100), zero = hn::Zero(D());
    const auto good = [&](V x)
                          HWY_ATTR { return hn::Or(hn::Eq(x, zero), hn::And(hn::Ge(x, least), hn::Le(x, greatest))); };
    return hn::And(hn::And(hn::And(good(a.norm), good(b.norm)), hn::And(good(c.norm), good(ab.norm))),
                   hn::And(hn::And(good(bc.norm), good(ca.norm)), good(r)));
  }

  // Finite, r >= 0, provided that no square overflows: x * 0 is not 0 if x is not finite, and |A|^2 is not finite if a
  // coordinate of A is not.
  AXISCERT_INLINE M is_valid() const {
    const V zero = hn::Zero(D());
    const V sum = hn::Add(hn::Add(dot(a.v, a.v).leading(), dot(b.v, b.v).leading()),
                          hn::Add(dot(c.v, c.v).leading(), rr.leading()));
    return hn::And(hn::Eq(hn::Mul(sum, zero), zero), hn::Ge(r, zero));
  }

  template <class Emit>
  AXISCERT_INLINE void emit_all(Emit&& emit) const {
    using enum Comparison;
    const T aa = dot(a.v, a.v), bb = dot(b.v, b.v), cc = dot(c.v, c.v);
    vertex(vertex_a_radius, aa, emit);
    vertex_side(vertex_a_side_b, dot(a.v, ab.v), aa, a, ab, emit);
    vertex_side(vertex_a_side_c, -dot(a.v, ca.v), aa, a, ca, emit);
    vertex(vertex_b_radius, bb, emit);
    vertex_side(vertex_b_side_a, -dot(b.v, ab.v), bb, b, ab, emit);
    vertex_side(vertex_b_side_c, dot(b.v, bc.v), bb, b, bc, emit);
    vertex(vertex_c_radius, cc, emit);
    vertex_side(vertex_c_side_a, dot(c.v, ca.v), cc, c, ca, emit);
    vertex_side(vertex_c_side_b, -dot(c.v, bc.v), cc, c, bc, emit);

    const Vec3<T> normal = cross(ca.v, ab.v);  // AB x AC
    const V no_area = hn::Zero(D());
    const V omega = hn::IfThenElse(hn::Eq(bc.norm, no_area), no_area,
                                   times(units<T>(MarginBounds::normal_units), times(ab.norm, ca.norm)));
    plane(normal, omega, emit);
    edge(edge_ab_radius, edge_ab_side_c, a, ab, normal, omega, emit);
    edge(edge_bc_radius, edge_bc_side_a, b, bc, normal, omega, emit);
    edge(edge_ca_radius, edge_ca_side_b, c, ca, normal, omega, emit);
  }

 private:
  // The scale is summed in doubles, from the leading parts.
  AXISCERT_INLINE static V scale_bound(V bound, V scale) { return plus(bound, times(constant(0x1p-48), scale)); }

  // |A|^2 - rr:  5 U |A|^2 + U rr, and U of the difference.
  template <class Emit>
  AXISCERT_INLINE void vertex(Comparison which, const T& aa, Emit& emit) const {
    const V scale = plus(aa.leading(), rr.leading());
    const V bound = times(units<T>(MarginBounds::vertex_radius_units), scale);
    emit(which, Margin<T>{aa - rr, bound, scale, scale_bound(bound, scale)});
  }

  // A.B - A.A = A.(B - A):  15 U |A|o |AB|o.  |A.B| + A.A, where A.B = A.A + margin: 10 U A.A more.
  template <class Emit>
  AXISCERT_INLINE void vertex_side(Comparison which, const T& margin, const T& aa, const Leaf<T>& from,
                                   const Leaf<T>& along, Emit& emit) const {
    const V bound = times(units<T>(MarginBounds::vertex_side_units), times(from.norm, along.norm));
    const V square = aa.leading();
    const V scale = plus(hn::Abs(plus(square, margin.leading())), square);
    // The first sum rounds relative to its larger operand; the 2^-48 of the square and the bound cover that.
    const V error = plus(plus(bound, times(units<T>(10), square)),
                         times(constant(0x1p-48), plus(square, hn::Abs(margin.leading()))));
    emit(which, Margin<T>{margin, bound, scale, scale_bound(error, scale)});
  }

  // d^2 - rr e:  2 |d^| delta + delta^2 + U d^2,  rr (2 omega |V^|1 + 3 omega^2 + 3 U e^) + 2 U rr e^, and
  // U of the difference.
  template <class Emit>
  AXISCERT_INLINE void plane(const Vec3<T>& normal, V omega, Emit& emit) const {
    const V sum = absolute_sum(normal);
    const T d = dot(a.v, normal), e = dot(normal, normal);
    const T lhs = d * d, rhs = rr * e;
    const V three_omega = times(constant(MarginBounds::thrice), omega);
    const V delta = times(a.norm, times_plus(units<T>(MarginBounds::offset_units), sum, three_omega));
    const V lhs_error = times_plus(delta,
                                   times_plus(constant(MarginBounds::twice), hn::Abs(d.leading()),
                                              times(delta, constant(MarginBounds::once_offset))),
                                   times(units<T>(MarginBounds::plane_lhs_units), lhs.leading()));
    const V rhs_error =
        times_plus(rr.leading(), times(omega, times_plus(constant(MarginBounds::twice), sum, three_omega)),
                   times(units<T>(MarginBounds::plane_rhs_units), rhs.leading()));
    const V bound = plus(lhs_error, rhs_error);
    const V scale = plus(lhs.leading(), rhs.leading());
    emit(Comparison::plane_radius, Margin<T>{lhs - rhs, bound, scale, scale_bound(bound, scale)});
  }

  // The pair of an edge: |N|^2 - rr e and -N.V (reduced), or e times these.
  //   |N|^2 - rr e:  2 nu |N^|1 + 3 nu^2 + 3 U |N^|^2 + 7 U rr e^
  //   -N.V:          omega |N^|1 + nu |V^|1 + 3 nu omega + 3 U |N^|1 |V^|1
  //   e times x:     e^ bound(x) + 6 U |e^ x^|
  template <class Emit>
  AXISCERT_INLINE void edge(Comparison radius, Comparison side, const Leaf<T>& from, const Leaf<T>& along,
                            const Vec3<T>& normal, V omega, Emit& emit) const {
    const Vec3<T> n = cross(from.v, along.v);
    const V nu = times(units<T>(MarginBounds::normal_units), times(from.norm, along.norm));
    const V n_sum = absolute_sum(n), v_sum = absolute_sum(normal);
    const T nn = dot(n, n), e = dot(along.v, along.v), rr_e = rr * e;
    const V radius_bound =
        times_plus(nu, times_plus(constant(MarginBounds::twice), n_sum, times(constant(MarginBounds::thrice), nu)),
                   times_plus(units<T>(MarginBounds::edge_square_units), nn.leading(),
                              times(units<T>(MarginBounds::edge_rhs_units), rr_e.leading())));
    // omega (n + 3 nu) + v (nu + 3 U n)
    const V side_bound = times_plus(
        times(omega, constant(MarginBounds::once)), times_plus(constant(MarginBounds::thrice_in_side), nu, n_sum),
        times(v_sum,
              times_plus(units<T>(MarginBounds::edge_side_units), n_sum, times(nu, constant(MarginBounds::once)))));
    Margin<T> of_radius{nn - rr_e, radius_bound, plus(nn.leading(), rr_e.leading()), {}};
    Margin<T> of_side{-dot(n, normal), side_bound, {}, {}};
    if constexpr (form == EdgeForm::published) {
      scale_by(of_radius, e);
      scale_by(of_side, e);
    }
    of_side.scale = hn::Abs(of_side.value.leading());
    for (Margin<T>* margin : {&of_radius, &of_side}) margin->scale_bound = scale_bound(margin->bound, margin->scale);
    emit(radius, of_radius);
    emit(side, of_side);
  }
  AXISCERT_INLINE static void scale_by(Margin<T>& margin, const T& e) {
    margin.value = margin.value * e;
    margin.bound = plus(times(e.leading(), margin.bound),
                        times(units<T>(MarginBounds::edge_length_units), hn::Abs(margin.value.leading())));
    margin.bound = times(margin.bound, constant(MarginBounds::once));
    margin.scale = times(margin.scale, e.leading());
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
