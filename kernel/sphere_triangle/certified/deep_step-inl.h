// The third step: single comparisons, one per lane, in pairs of doubles; the sign of a value too small for these comes
// from its residue modulo 2^64 where that suffices. No include guard: included once for each of Highway's instruction
// sets, after wrapped-inl.h.
//
// The vertices of the query are renamed so that the comparison belongs to vertex A, edge AB or the plane.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

enum class DeepComparison : std::uint8_t { vertex_radius, vertex_sides, edge_radius, edge_side, plane_radius };
inline constexpr std::size_t comparing_count = 5;

template <class D>
class DeepStep {
 public:
  using V = hn::Vec<D>;
  using M = hn::Mask<D>;
  // Certain results. holds: the comparison holds, or all of them for sides; fails: the axis does not separate.
  struct Answer {
    M holds, fails;
  };

  AXISCERT_INLINE DeepStep(D d, const Problem<Lanes<D>>& q, bool open_sphere) : d_(d), open_(open_sphere), m_(q) {}

  template <DeepComparison what>
  AXISCERT_INLINE Answer answer() const {
    const Answer found = answer_in_range<what>();
    // The leaves that are used have to be in the range of the bounds' derivation.
    M sound = hn::And(in_range(m_.a), PairMargins::in_range(m_.r));
    if constexpr (what != DeepComparison::vertex_radius) sound = hn::And(sound, in_range(m_.ab));
    if constexpr (what != DeepComparison::vertex_radius && what != DeepComparison::edge_radius) {
      sound = hn::And(sound, in_range(m_.ca));
    }
    return {hn::And(found.holds, sound), hn::And(found.fails, sound)};
  }

 private:
  template <DeepComparison what>
  AXISCERT_INLINE Answer answer_in_range() const {
    if constexpr (what == DeepComparison::vertex_radius) return vertex_radius();
    else if constexpr (what == DeepComparison::vertex_sides) return vertex_sides();
    else if constexpr (what == DeepComparison::edge_radius) return edge_radius();
    else if constexpr (what == DeepComparison::edge_side) return edge_side();
    else return plane_radius();
  }

  using W = WrappedWords<D>;
  using PairMargins = Margins<D, Pairs<D>>;
  using Margin = typename PairMargins::Margin;
  using Normal = typename PairMargins::Normal;

  // The sign of an exact margin, where it is certain.
  struct Sign {
    M positive, negative, zero;
    AXISCERT_INLINE M open() const { return hn::Not(hn::Or(hn::Or(positive, negative), zero)); }
    AXISCERT_INLINE Sign operator-() const { return {negative, positive, zero}; }
  };
  AXISCERT_INLINE static M in_range(const typename PairMargins::Leaf& leaf) { return PairMargins::in_range(leaf.norm); }
  AXISCERT_INLINE M none() const { return hn::MaskFromVec(hn::Zero(d_)); }
  AXISCERT_INLINE Sign sign(const Margin& margin) const {
    return {hn::Gt(margin.value, margin.bound), hn::Lt(margin.value, hn::Neg(margin.bound)), none()};
  }
  // Adds the sign of a margin, where it is open, as far as the margin's residue tells it.
  template <int degree>
  AXISCERT_INLINE static void include(const Margin& margin, const W& residue, M is_exact, const Units<D>& units,
                                      Sign& sign) {
    const M known = hn::And(hn::And(sign.open(), is_exact), units.template is_known<degree>(margin.bound));
    const M zero = residue.is_zero(), negative = residue.is_negative();
    sign.positive = hn::Or(sign.positive, hn::AndNot(hn::Or(zero, negative), known));
    sign.negative = hn::Or(sign.negative, hn::And(known, negative));
    sign.zero = hn::And(known, zero);
  }
  // Lanes in which a normal with this residue is known to be zero.
  AXISCERT_INLINE static M is_known_zero(const Normal& normal, const Vec3<W>& residue, const Units<D>& units) {
    return hn::And(
        hn::And(hn::And(units.are_exact(), units.template is_known<2>(normal.error)), hn::Le(normal.sum, normal.error)),
        is_zero(residue));
  }

  AXISCERT_INLINE static Answer side(const Sign& sign) { return {hn::Or(sign.positive, sign.zero), sign.negative}; }
  AXISCERT_INLINE Answer radius(const Sign& sign) const {
    if (open_) return {hn::Or(sign.positive, sign.zero), sign.negative};
    return {sign.positive, hn::Or(sign.negative, sign.zero)};
  }
  // A radius comparison whose left side is zero fails; with the open sphere only if r > 0.
  AXISCERT_INLINE M within_if(M lhs_is_zero) const {
    return open_ ? hn::And(lhs_is_zero, hn::Gt(m_.r, hn::Zero(d_))) : lhs_is_zero;
  }

  AXISCERT_INLINE Answer vertex_radius() const {
    const Margin margin = m_.vertex_radius(m_.a);
    Sign found = sign(margin);
    if (!hn::AllFalse(d_, found.open())) {
      const Units<D> units(d_, {m_.a.v}, m_.r);
      const Vec3<W> a = units.integer(m_.a.v);
      const W r = units.integer(m_.r);
      include<2>(margin, dot(a, a) - r * r, units.radius_is_exact(), units, found);
    }
    return radius(found);
  }
  AXISCERT_INLINE Answer vertex_sides() const {
    const Margin away = m_.vertex_side(m_.a, m_.ab), towards = m_.vertex_side(m_.a, m_.ca);
    Sign first = sign(away), second = sign(towards);
    if (!hn::AllFalse(d_, hn::Or(first.open(), second.open()))) {
      const Units<D> units(d_, {m_.a.v, m_.ab.v, m_.ca.v}, hn::Zero(d_));
      const Vec3<W> a = units.integer(m_.a.v);
      include<2>(away, dot(a, units.integer(m_.ab.v)), units.are_exact(), units, first);
      include<2>(towards, dot(a, units.integer(m_.ca.v)), units.are_exact(), units, second);
    }
    const Answer one = side(first), other = side(-second);
    return {hn::And(one.holds, other.holds), hn::Or(one.fails, other.fails)};
  }
  AXISCERT_INLINE Answer edge_radius() const {
    const Normal N = PairMargins::normal_of(m_.a, m_.ab);
    const Margin margin = m_.edge_radius(N, m_.ab);
    Sign found = sign(margin);
    M on_line = none();
    if (!hn::AllFalse(d_, found.open())) {
      const Units<D> units(d_, {m_.a.v, m_.ab.v}, m_.r);
      const Vec3<W> ab = units.integer(m_.ab.v), n = cross(units.integer(m_.a.v), ab);
      const W r = units.integer(m_.r);
      include<4>(margin, dot(n, n) - r * r * dot(ab, ab), units.radius_is_exact(), units, found);
      on_line = is_known_zero(N, n, units);
    }
    const Answer answer = radius(found);
    return {answer.holds, hn::Or(answer.fails, within_if(on_line))};
  }
  AXISCERT_INLINE Answer edge_side() const {
    const Normal normal = m_.normal();
    const Margin margin = m_.edge_side(PairMargins::normal_of(m_.a, m_.ab), normal);
    Sign found = sign(margin);
    if (!hn::AllFalse(d_, found.open())) {
      const Units<D> units(d_, {m_.a.v, m_.ab.v, m_.ca.v}, hn::Zero(d_));
      const Vec3<W> ab = units.integer(m_.ab.v), n = cross(units.integer(m_.ca.v), ab);
      include<4>(margin, -dot(cross(units.integer(m_.a.v), ab), n), units.are_exact(), units, found);
      found.zero = hn::Or(found.zero, is_known_zero(normal, n, units));
    }
    return side(found);
  }
  AXISCERT_INLINE Answer plane_radius() const {
    const Normal normal = m_.normal();
    const auto offset = m_.offset(normal);
    const Margin margin = m_.plane_radius(normal, offset);
    Sign found = sign(margin);
    M flat = none(), on_plane = none();
    if (!hn::AllFalse(d_, found.open())) {
      const Units<D> units(d_, {m_.a.v, m_.ab.v, m_.ca.v}, m_.r);
      const Vec3<W> n = cross(units.integer(m_.ca.v), units.integer(m_.ab.v));
      const W d = dot(units.integer(m_.a.v), n), r = units.integer(m_.r);
      include<6>(margin, d * d - r * r * dot(n, n), units.radius_is_exact(), units, found);
      flat = is_known_zero(normal, n, units);
      const M is_small = hn::Le(PairMargins::size_of(offset.value), offset.error);
      on_plane =
          hn::And(hn::And(units.are_exact(), units.template is_known<3>(offset.error)), hn::And(is_small, d.is_zero()));
    }
    // For the open sphere a tie is left open: a triangle without area gives one too, but has no such axis.
    const Answer answer = open_ ? Answer{found.positive, found.negative} : radius(found);
    return {answer.holds, hn::Or(answer.fails, hn::Or(flat, within_if(on_plane)))};
  }

  D d_;
  bool open_;
  PairMargins m_;
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
