// The second step: the margins in doubles, each against its own bound. No include guard: included once for each of
// Highway's instruction sets, after margins-inl.h.
//
// Repeated vertices are decided here, because their bounds are zero: a side of 0 >= 0 holds, a radius of 0 > 0 does
// not.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class D>
struct FineStep : Margins<D, Lanes<D>> {
  using Base = Margins<D, Lanes<D>>;
  using Base::a, Base::b, Base::c, Base::ab, Base::bc, Base::ca, Base::rr, Base::r;
  using Base::constant, Base::in_range, Base::is_zero;
  using typename Base::Leaf, typename Base::M, typename Base::Margin, typename Base::Normal, typename Base::V;
  using Words = hn::RebindToUnsigned<D>;

  using Axis = AxisMasks<D>;  // an axis whose normal is zero fails

  D d;
  bool open;  // whether a tie of a radius comparison counts as beyond

  AXISCERT_INLINE FineStep(D lanes, const Problem<Lanes<D>>& q, bool open_sphere)
      : Base(q), d(lanes), open(open_sphere) {}

  AXISCERT_INLINE static M always() { return hn::Eq(hn::Zero(D()), hn::Zero(D())); }
  AXISCERT_INLINE static M never() { return hn::MaskFromVec(hn::Zero(D())); }
  // sides: the exact margin is >= 0; fails: it is < 0.
  AXISCERT_INLINE static void side(const Margin& margin, Axis& axis) {
    axis.sides = hn::And(axis.sides, hn::Ge(margin.value, margin.bound));
    axis.fails = hn::Or(axis.fails, hn::Lt(margin.value, hn::Neg(margin.bound)));
  }
  // radius: the exact margin is > 0; fails: it is <= 0. For the open sphere a tie counts as beyond, but is never
  // certain here.
  AXISCERT_INLINE Axis radius(const Margin& margin, M has_no_normal) const {
    const V least = hn::Neg(margin.bound);
    const M within = open ? hn::Lt(margin.value, least) : hn::Le(margin.value, least);
    return {hn::Gt(margin.value, margin.bound), always(), hn::Or(has_no_normal, within)};
  }

  // Finite numbers and r >= 0. The squares of binary32 numbers stay finite.
  AXISCERT_INLINE M is_valid() const {
    const Lanes<D> size = ((dot(a.v, a.v) + dot(b.v, b.v)) + dot(c.v, c.v)) + rr;
    return hn::And(hn::Lt(size.v, constant(std::numeric_limits<double>::infinity())), hn::Ge(r, hn::Zero(d)));
  }

  AXISCERT_INLINE M is_sound() const {
    return hn::And(hn::And(hn::And(in_range(a.norm), in_range(b.norm)), hn::And(in_range(c.norm), in_range(ab.norm))),
                   hn::And(hn::And(in_range(bc.norm), in_range(ca.norm)), in_range(r)));
  }

  AXISCERT_INLINE Axis vertex(const Leaf& from, const Leaf& away, const Leaf& towards) const {
    Axis axis = radius(this->vertex_radius(from), never());
    side(this->vertex_side(from, away), axis);
    side(this->opposite_vertex_side(from, towards), axis);
    return axis;
  }
  AXISCERT_INLINE Axis plane(const Normal& normal) const {
    return radius(this->plane_radius(normal, this->offset(normal)),
                  hn::And(is_zero(normal.error), is_zero(normal.sum)));
  }
  AXISCERT_INLINE Axis edge(const Leaf& from, const Leaf& along, const Normal& normal) const {
    const Normal N = Base::normal_of(from, along);
    Axis axis = radius(this->edge_radius(N, along), is_zero(along.norm));
    side(this->edge_side(N, normal), axis);
    return axis;
  }

  struct Answer {
    DecidedLanes<D> decided;
    hn::Vec<Words> known;  // the bits of Known
  };

  AXISCERT_INLINE Answer answer() const {
    const Normal normal = this->normal();
    const Axis axes[] = {vertex(a, ab, ca),   vertex(b, bc, ab),   vertex(c, ca, bc),  plane(normal),
                         edge(a, ab, normal), edge(b, bc, normal), edge(c, ca, normal)};
    Answer found{{never(), always()}, hn::Zero(Words())};
    for (int i = 0; i < KnownResults::axes; ++i) {
      found.decided.separated = hn::Or(found.decided.separated, hn::And(axes[i].radius, axes[i].sides));
      found.decided.contact = hn::And(found.decided.contact, axes[i].fails);
    }
    if (hn::AllTrue(d, hn::Or(found.decided.separated, found.decided.contact))) return found;
    for (int i = 0; i < KnownResults::axes; ++i) note(d, axes[i], i, found.known);
    return found;
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
