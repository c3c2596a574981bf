// The second step: the same margins in doubles, each with a bound of its own from the leaves that it is made of
// (docs/error_model.md, "The bounds of lanes"; the constants in kernel/filter/margin_bounds.h). No guard: included once
// for each of Highway's instruction sets, after coarse_step-inl.h.
//
// A bound that is zero means operands that are exact zeros, so repeated vertices are decided here: a side of 0 >= 0
// holds, a radius of 0 > 0 does not.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {
using filter::MarginBounds;

template <class D>
struct FineStep {
  using T = Lanes<D>;
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  using Words = hn::RebindToUnsigned<D>;

  struct Leaf {
    Vec3<T> v;
    V norm;  // the greatest component
    AXISCERT_INLINE Leaf(const Vec3<T>& from, const Vec3<T>& to)
        : v(to - from), norm(hn::Max(hn::Max(hn::Abs(v.x.v), hn::Abs(v.y.v)), hn::Abs(v.z.v))) {}
  };
  // What is certain of one axis: its radius comparison holds, its sides hold, one of them fails. An axis whose normal
  // is zero fails.
  struct Axis {
    M radius, sides, fails;
  };

  D d;
  bool open;  // the question: is a tie of a radius comparison beyond
  Leaf a, b, c, ab, bc, ca;
  T rr;
  V r;

  AXISCERT_INLINE FineStep(D lanes, const Problem<T>& q, bool open_sphere)
      : d(lanes),
        open(open_sphere),
        a(q.p, q.a),
        b(q.p, q.b),
        c(q.p, q.c),
        ab(q.a, q.b),
        bc(q.b, q.c),
        ca(q.c, q.a),
        rr(q.r * q.r),
        r(q.r.v) {}

  AXISCERT_INLINE static V units(double n) { return hn::Set(D(), n * 0x1p-53 * MarginBounds::unit_factor); }
  AXISCERT_INLINE static V constant(double x) { return hn::Set(D(), x); }
  AXISCERT_INLINE static V sum_of_sizes(const Vec3<T>& v) {
    return hn::Add(hn::Add(hn::Abs(v.x.v), hn::Abs(v.y.v)), hn::Abs(v.z.v));
  }
  AXISCERT_INLINE static M is_zero(V x) { return hn::Eq(x, hn::Zero(D())); }

  AXISCERT_INLINE static M always() { return hn::Eq(hn::Zero(D()), hn::Zero(D())); }
  // exact margin >= 0, or < 0.
  AXISCERT_INLINE static void side(V margin, V bound, Axis& axis) {
    axis.sides = hn::And(axis.sides, hn::Ge(margin, bound));
    axis.fails = hn::Or(axis.fails, hn::Lt(margin, hn::Neg(bound)));
  }
  // exact margin > 0, or <= 0; for the open sphere a tie counts as beyond, but is never certain here.
  AXISCERT_INLINE Axis radius(V margin, V bound, M has_no_normal) const {
    const M within = open ? hn::Lt(margin, hn::Neg(bound)) : hn::Le(margin, hn::Neg(bound));
    return {hn::Gt(margin, bound), always(), hn::Or(has_no_normal, within)};
  }

  // Finite, r >= 0: the squares of binary32 stay finite.
  AXISCERT_INLINE M is_valid() const {
    const T size = ((dot(a.v, a.v) + dot(b.v, b.v)) + dot(c.v, c.v)) + rr;
    return hn::And(hn::Lt(size.v, constant(std::numeric_limits<double>::infinity())), hn::Ge(r, hn::Zero(d)));
  }

  // Each leaf and r zero or in the range that keeps underflow out of the bounds.
  AXISCERT_INLINE M in_range() const {
    const auto good = [](V x) HWY_ATTR {
      return hn::Or(is_zero(x), hn::And(hn::Ge(x, constant(least_fine_leaf)), hn::Le(x, constant(greatest_fine_leaf))));
    };
    return hn::And(hn::And(hn::And(good(a.norm), good(b.norm)), hn::And(good(c.norm), good(ab.norm))),
                   hn::And(hn::And(good(bc.norm), good(ca.norm)), good(r)));
  }

  // sign: +1 where `along` leads away from the vertex, -1 where it leads to it.
  AXISCERT_INLINE Axis vertex(const Leaf& from, const Leaf& away, const Leaf& towards) const {
    const T square = dot(from.v, from.v);
    Axis axis = radius((square - rr).v, hn::Mul(units(MarginBounds::vertex_radius_units), (square + rr).v),
                       hn::MaskFromVec(hn::Zero(d)));
    const V one = hn::Mul(units(MarginBounds::vertex_side_units), from.norm);
    side(dot(from.v, away.v).v, hn::Mul(one, away.norm), axis);
    side(hn::Neg(dot(from.v, towards.v).v), hn::Mul(one, towards.norm), axis);
    return axis;
  }

  AXISCERT_INLINE Axis plane(const Vec3<T>& normal, V omega) const {
    const V sum = sum_of_sizes(normal);
    const T offset = dot(a.v, normal), e = dot(normal, normal);
    const T lhs = offset * offset, rhs = rr * e;
    const V three_omega = hn::Mul(constant(MarginBounds::thrice), omega);
    const V delta = hn::Mul(a.norm, hn::MulAdd(units(MarginBounds::offset_units), sum, three_omega));
    const V lhs_error = hn::MulAdd(delta,
                                   hn::MulAdd(constant(MarginBounds::twice), hn::Abs(offset.v),
                                              hn::Mul(delta, constant(MarginBounds::once_offset))),
                                   hn::Mul(units(MarginBounds::plane_lhs_units), lhs.v));
    const V rhs_error = hn::MulAdd(rr.v, hn::Mul(omega, hn::MulAdd(constant(MarginBounds::twice), sum, three_omega)),
                                   hn::Mul(units(MarginBounds::plane_rhs_units), rhs.v));
    const M has_no_normal = hn::And(is_zero(omega), is_zero(sum));
    return radius((lhs - rhs).v, hn::Add(lhs_error, rhs_error), has_no_normal);
  }

  AXISCERT_INLINE Axis edge(const Leaf& from, const Leaf& along, const Vec3<T>& normal, V omega, V normal_sum) const {
    const Vec3<T> N = cross(from.v, along.v);
    const V nu = hn::Mul(units(MarginBounds::normal_units), hn::Mul(from.norm, along.norm)), sum = sum_of_sizes(N);
    const T square = dot(N, N), rhs = rr * dot(along.v, along.v);
    const V radius_bound =
        hn::MulAdd(nu, hn::MulAdd(constant(MarginBounds::twice), sum, hn::Mul(constant(MarginBounds::thrice), nu)),
                   hn::MulAdd(units(MarginBounds::edge_square_units), square.v,
                              hn::Mul(units(MarginBounds::edge_rhs_units), rhs.v)));
    Axis axis = radius((square - rhs).v, radius_bound, is_zero(along.norm));
    const V side_bound = hn::MulAdd(
        hn::Mul(omega, constant(MarginBounds::once)), hn::MulAdd(constant(MarginBounds::thrice_in_side), nu, sum),
        hn::Mul(normal_sum,
                hn::MulAdd(units(MarginBounds::edge_side_units), sum, hn::Mul(nu, constant(MarginBounds::once)))));
    side(hn::Neg(dot(N, normal).v), side_bound, axis);
    return axis;
  }

  struct Answer {
    Decided<D> decided;
    hn::Vec<Words> known;  // Known's bits
  };

  AXISCERT_INLINE Answer answer() const {
    // AB x AC, zero where B = C. There AB = -CA to the bit, but a fused cross product of these need not vanish.
    const M b_is_c = is_zero(bc.norm);
    Vec3<T> normal = cross(ca.v, ab.v);
    for (T* x : {&normal.x, &normal.y, &normal.z}) x->v = hn::IfThenZeroElse(b_is_c, x->v);
    const V omega = hn::IfThenZeroElse(b_is_c, hn::Mul(units(MarginBounds::normal_units), hn::Mul(ab.norm, ca.norm)));
    const V normal_sum = sum_of_sizes(normal);
    const Axis axes[] = {vertex(a, ab, ca),
                         vertex(b, bc, ab),
                         vertex(c, ca, bc),
                         plane(normal, omega),
                         edge(a, ab, normal, omega, normal_sum),
                         edge(b, bc, normal, omega, normal_sum),
                         edge(c, ca, normal, omega, normal_sum)};
    Answer found{{hn::MaskFromVec(hn::Zero(d)), always()}, hn::Zero(Words())};
    for (int i = 0; i < 7; ++i) {
      found.decided.separated = hn::Or(found.decided.separated, hn::And(axes[i].radius, axes[i].sides));
      found.decided.contact = hn::And(found.decided.contact, axes[i].fails);
    }
    if (hn::AllTrue(d, hn::Or(found.decided.separated, found.decided.contact))) return found;
    for (int i = 0; i < 7; ++i) {
      note(axes[i].fails, Known::fails + i, found.known);
      note(axes[i].radius, Known::radius + i, found.known);
      note(axes[i].sides, Known::sides + i, found.known);
    }
    return found;
  }
  AXISCERT_INLINE static void note(M mask, int bit, hn::Vec<Words>& known) {
    const auto one = hn::Set(Words(), std::uint64_t{1} << bit);
    known = hn::Or(known, hn::And(hn::BitCast(Words(), hn::VecFromMask(D(), mask)), one));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
