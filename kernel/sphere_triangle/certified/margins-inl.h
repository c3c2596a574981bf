// The sixteen margins of the reduced form, each with a bound of its error computed from its leaves, over a number type
// T of lanes: doubles for the fine step, pairs of doubles for the deep one. exact/sphere_triangle/oracles/margins-inl.h
// has the derivation, kernel/sphere_triangle/forms/margin_bounds.h the constants. No include guard: included
// once for each of Highway's instruction sets, after coarse_step-inl.h.
//
// T::unit is U, the relative error that the derivation allows per operation; T::leading is the double nearest to a
// number.
//
// A bound that is zero means that the operands are exact zeros: the margin is exact.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {
using filter::MarginBounds;

template <class D, class T>
struct Margins {
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;

  struct Leaf {
    Vec3<T> v;
    V norm;  // the greatest component
    AXISCERT_INLINE Leaf(const Vec3<Lanes<D>>& from, const Vec3<Lanes<D>>& to)
        : v{T::difference(to.x.v, from.x.v), T::difference(to.y.v, from.y.v), T::difference(to.z.v, from.z.v)},
          norm(hn::Max(hn::Max(size_of(v.x), size_of(v.y)), size_of(v.z))) {}
  };
  // A cross product of leaves; the error of each component is at most `error`.
  struct Normal {
    Vec3<T> v;
    V error, sum;  // sum: of the components' magnitudes
  };
  struct Margin {
    V value, bound;
  };

  Leaf a, b, c, ab, bc, ca;
  T rr;
  V r;

  AXISCERT_INLINE explicit Margins(const Problem<Lanes<D>>& q)
      : a(q.p, q.a),
        b(q.p, q.b),
        c(q.p, q.c),
        ab(q.a, q.b),
        bc(q.b, q.c),
        ca(q.c, q.a),
        rr(T::square(q.r.v)),
        r(q.r.v) {}

  AXISCERT_INLINE static V units(double n) { return hn::Set(D(), n * T::unit * MarginBounds::unit_factor); }
  AXISCERT_INLINE static V constant(double x) { return hn::Set(D(), x); }
  AXISCERT_INLINE static M is_zero(V x) { return hn::Eq(x, hn::Zero(D())); }
  // Whether a leaf's norm, or r, is in the range that keeps underflow out of the bounds.
  AXISCERT_INLINE static M in_range(V x) {
    return hn::Or(is_zero(x), hn::And(hn::Ge(x, constant(least_fine_leaf)), hn::Le(x, constant(greatest_fine_leaf))));
  }
  AXISCERT_INLINE static V size_of(const T& x) { return hn::Abs(x.leading()); }

  AXISCERT_INLINE static Normal normal_of(const Leaf& x, const Leaf& y) {
    return with_sum(cross(x.v, y.v), hn::Mul(units(MarginBounds::normal_units), hn::Mul(x.norm, y.norm)));
  }
  // AB x AC, made zero where B = C. There AB = -CA to the bit, but a fused cross product of these need not vanish.
  AXISCERT_INLINE Normal normal() const {
    const M b_is_c = is_zero(bc.norm);
    const Normal n = normal_of(ca, ab);
    return with_sum({n.v.x.zero_where(b_is_c), n.v.y.zero_where(b_is_c), n.v.z.zero_where(b_is_c)},
                    hn::IfThenZeroElse(b_is_c, n.error));
  }

  AXISCERT_INLINE Margin vertex_radius(const Leaf& from) const {
    const T square = dot(from.v, from.v);
    return {(square - rr).leading(),
            hn::Mul(units(MarginBounds::vertex_radius_units), hn::Add(square.leading(), rr.leading()))};
  }
  // `away` leads from the vertex to another.
  AXISCERT_INLINE Margin vertex_side(const Leaf& from, const Leaf& away) const {
    return {dot(from.v, away.v).leading(),
            hn::Mul(hn::Mul(units(MarginBounds::vertex_side_units), from.norm), away.norm)};
  }
  // `towards` leads from another vertex to this one.
  AXISCERT_INLINE Margin opposite_vertex_side(const Leaf& from, const Leaf& towards) const {
    const Margin margin = vertex_side(from, towards);
    return {hn::Neg(margin.value), margin.bound};
  }
  // A.V, whose square is the left side of the plane's radius comparison.
  struct Offset {
    T value;
    V error;
  };
  AXISCERT_INLINE Offset offset(const Normal& n) const {
    const V three_omega = hn::Mul(constant(MarginBounds::thrice), n.error);
    return {dot(a.v, n.v), hn::Mul(a.norm, hn::MulAdd(units(MarginBounds::offset_units), n.sum, three_omega))};
  }
  AXISCERT_INLINE Margin plane_radius(const Normal& n, const Offset& d) const {
    const T lhs = d.value * d.value, rhs = rr * dot(n.v, n.v);
    const V three_omega = hn::Mul(constant(MarginBounds::thrice), n.error), delta = d.error;
    const V lhs_error = hn::MulAdd(delta,
                                   hn::MulAdd(constant(MarginBounds::twice), size_of(d.value),
                                              hn::Mul(delta, constant(MarginBounds::once_offset))),
                                   hn::Mul(units(MarginBounds::plane_lhs_units), lhs.leading()));
    const V rhs_error =
        hn::MulAdd(rr.leading(), hn::Mul(n.error, hn::MulAdd(constant(MarginBounds::twice), n.sum, three_omega)),
                   hn::Mul(units(MarginBounds::plane_rhs_units), rhs.leading()));
    return {(lhs - rhs).leading(), hn::Add(lhs_error, rhs_error)};
  }
  // N = normal_of(vertex, along).
  AXISCERT_INLINE Margin edge_radius(const Normal& N, const Leaf& along) const {
    const T square = dot(N.v, N.v), rhs = rr * dot(along.v, along.v);
    const V bound = hn::MulAdd(
        N.error, hn::MulAdd(constant(MarginBounds::twice), N.sum, hn::Mul(constant(MarginBounds::thrice), N.error)),
        hn::MulAdd(units(MarginBounds::edge_square_units), square.leading(),
                   hn::Mul(units(MarginBounds::edge_rhs_units), rhs.leading())));
    return {(square - rhs).leading(), bound};
  }
  AXISCERT_INLINE Margin edge_side(const Normal& N, const Normal& n) const {
    const V bound = hn::MulAdd(hn::Mul(n.error, constant(MarginBounds::once)),
                               hn::MulAdd(constant(MarginBounds::thrice_in_side), N.error, N.sum),
                               hn::Mul(n.sum, hn::MulAdd(units(MarginBounds::edge_side_units), N.sum,
                                                         hn::Mul(N.error, constant(MarginBounds::once)))));
    return {hn::Neg(dot(N.v, n.v).leading()), bound};
  }

 private:
  AXISCERT_INLINE static Normal with_sum(const Vec3<T>& v, V error) {
    return {v, error, hn::Add(hn::Add(size_of(v.x), size_of(v.y)), size_of(v.z))};
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
