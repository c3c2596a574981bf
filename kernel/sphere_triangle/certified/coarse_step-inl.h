// The first step: the margins of the reduced form in the input's precision, one query per lane, against one threshold
// for each degree (kernel/sphere_triangle/certified/thresholds.h has the derivation). No include guard: included once
// for each of Highway's instruction sets.
//
// The step costs less than the test that it certifies: each axis is reduced to the least of its margins, the axes of a
// degree to the greatest of these, and only that is compared. Dot products need not be in the published order, so they
// are fused.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using axiscert::HWY_NAMESPACE::cross, axiscert::HWY_NAMESPACE::dot, axiscert::HWY_NAMESPACE::Problem,
    axiscert::HWY_NAMESPACE::Vec3;

// N queries at once. Dot and cross products are fused if `fused` is true and the instruction set has fused
// multiply-add.
template <class D, bool fused = true>
struct Lanes {
  using V = hn::Vec<D>;
  static constexpr double unit = unit_roundoff<hn::TFromD<D>>;
  V v;
  AXISCERT_INLINE V leading() const { return v; }
  AXISCERT_INLINE Lanes zero_where(hn::Mask<D> mask) const { return {hn::IfThenZeroElse(mask, v)}; }
  AXISCERT_INLINE static Lanes difference(V x, V y) { return {hn::Sub(x, y)}; }
  AXISCERT_INLINE static Lanes square(V x) { return {hn::Mul(x, x)}; }
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return {hn::Add(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return {hn::Sub(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return {hn::Mul(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a) { return {hn::Neg(a.v)}; }
  // c - a b.
  AXISCERT_INLINE static Lanes minus_product(const Lanes& c, const Lanes& a, const Lanes& b) {
    if constexpr (fused) return {hn::NegMulAdd(a.v, b.v, c.v)};
    else return c - a * b;
  }
  AXISCERT_INLINE static Lanes dot(const Vec3<Lanes>& a, const Vec3<Lanes>& b)
    requires fused
  {
    return {hn::MulAdd(a.z.v, b.z.v, hn::MulAdd(a.y.v, b.y.v, hn::Mul(a.x.v, b.x.v)))};
  }
  AXISCERT_INLINE static Vec3<Lanes> cross(const Vec3<Lanes>& a, const Vec3<Lanes>& b)
    requires fused
  {
    return {minus_product(a.y * b.z, a.z, b.y), minus_product(a.z * b.x, a.x, b.z), minus_product(a.x * b.y, a.y, b.x)};
  }
};
template <class D, bool fused>
AXISCERT_INLINE Lanes<D, fused> least(const Lanes<D, fused>& a, const Lanes<D, fused>& b) {
  return {hn::Min(a.v, b.v)};
}
template <class D, bool fused>
AXISCERT_INLINE Lanes<D, fused> greatest(const Lanes<D, fused>& a, const Lanes<D, fused>& b) {
  return {hn::Max(a.v, b.v)};
}

// Lanes in neither mask are passed on: a margin within its threshold, a magnitude outside the range, or an invalid
// query.
template <class D>
struct DecidedLanes {
  hn::Mask<D> separated, contact;
};

// Certain results for one axis: its radius comparison holds, its side comparisons hold, one of its comparisons fails.
template <class D>
struct AxisMasks {
  hn::Mask<D> radius, sides, fails;
};
// Adds the masks to `known` as the bits of Known.
template <class D>
AXISCERT_INLINE void note(D d, const AxisMasks<D>& masks, int axis, hn::Vec<hn::RebindToUnsigned<D>>& known) {
  const hn::RebindToUnsigned<D> words;
  const auto add = [&](hn::Mask<D> mask, int bit) HWY_ATTR {
    const auto one = hn::Set(words, static_cast<hn::TFromD<hn::RebindToUnsigned<D>>>(std::uint64_t{1} << (bit + axis)));
    known = hn::Or(known, hn::And(hn::BitCast(words, hn::VecFromMask(d, mask)), one));
  };
  add(masks.fails, KnownResults::fails);
  add(masks.radius, KnownResults::radius);
  add(masks.sides, KnownResults::sides);
}

// The thresholds of a query of magnitude S whose triangle has the size E, and how margins compare with them: for each
// degree, the greatest over the axes.
template <class D, bool fused>
struct CoarseLimits {
  using T = Lanes<D, fused>;
  using Real = hn::TFromD<D>;
  T degree2, degree4, degree6;

  AXISCERT_INLINE CoarseLimits(const T& S, const T& E)
      : degree2(units(filter::CoarseBounds::degree_2) * S),
        degree4(units(filter::CoarseBounds::degree_4) * (S * E)),
        degree6(units(filter::CoarseBounds::degree_6) * ((S * E) * E)) {}
  AXISCERT_INLINE static T units(double n) {
    constexpr double u = unit_roundoff<Real>;
    return {hn::Set(D(), static_cast<Real>(n * u))};
  }
  AXISCERT_INLINE hn::Mask<D> any_beyond(const T& vertices, const T& edges, const T& plane) const {
    return hn::Or(hn::Or(hn::Gt(vertices.v, degree2.v), hn::Gt(edges.v, degree4.v)), hn::Gt(plane.v, degree6.v));
  }
  AXISCERT_INLINE hn::Mask<D> all_within(const T& vertices, const T& edges, const T& plane) const {
    return hn::And(hn::And(hn::Lt(vertices.v, hn::Neg(degree2.v)), hn::Lt(edges.v, hn::Neg(degree4.v))),
                   hn::Lt(plane.v, hn::Neg(degree6.v)));
  }
  // Valid queries of magnitudes for which the deep step's range (Margins::in_range) mostly holds; the deep step checks
  // its range itself.
  AXISCERT_INLINE static hn::Mask<D> in_deep_range(const T& S, const T& r) {
    return hn::And(hn::And(hn::Ge(S.v, hn::Set(D(), Real{0x1p-100})), hn::Le(S.v, hn::Set(D(), Real{0x1p198}))),
                   hn::Ge(r.v, hn::Zero(D())));
  }
  // S is not in the range if a number is not finite; r >= 0 has to be tested besides.
  AXISCERT_INLINE static hn::Mask<D> in_range(const T& S, const T& r) {
    return hn::And(
        hn::And(hn::Ge(S.v, hn::Set(D(), least_square<Real>)), hn::Le(S.v, hn::Set(D(), greatest_square<Real>))),
        hn::Ge(r.v, hn::Zero(D())));
  }
};

// The sixteen margins.
template <class D, bool fused>
struct CoarseMargins {
  using T = Lanes<D, fused>;
  struct Vertex {
    T radius, away, towards;
  };
  struct Edge {
    T radius, side;
  };
  Vertex vertex[3];
  T plane;
  Edge edge[3];
  T S, E, r;
};
template <class D, bool fused>
AXISCERT_INLINE CoarseMargins<D, fused> coarse_margins(const Problem<Lanes<D, fused>>& q) {
  using T = Lanes<D, fused>;
  const Vec3<T> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p;
  const Vec3<T> AB = q.b - q.a, BC = q.c - q.b, CA = q.a - q.c;
  const T aa = dot(A, A), bb = dot(B, B), cc = dot(C, C), rr = q.r * q.r;
  const T e1 = dot(AB, AB), e2 = dot(BC, BC), e3 = dot(CA, CA);
  const T S = ((aa + bb) + cc) + rr;
  const T least{hn::Set(D(), static_cast<hn::TFromD<D>>(least_relative_triangle))};
  const T E = ((e1 + e2) + e3) + least * S;

  // 2 A.AB = (B.B - A.A) - e1, and so on.
  const T ab = bb - aa, ac = cc - aa, bc = cc - bb;

  const Vec3<T> V = cross(CA, AB);  // AB x AC
  const auto edge = [&](const Vec3<T>& from, const Vec3<T>& along, const T& e) HWY_ATTR {
    const Vec3<T> N = cross(from, along);
    return typename CoarseMargins<D, fused>::Edge{T::minus_product(dot(N, N), rr, e), -dot(N, V)};
  };
  const T offset = dot(A, V);
  return {{{aa - rr, ab - e1, ac - e3}, {bb - rr, bc - e2, -ab - e1}, {cc - rr, -ac - e3, -bc - e2}},
          T::minus_product(offset * offset, rr, dot(V, V)),
          {edge(A, AB, e1), edge(B, BC, e2), edge(C, CA, e3)},
          S,
          E,
          q.r};
}

// The results for each comparison, in doubles, as the bits of Known; for lanes in the range of the step.
template <class D, bool fused>
AXISCERT_INLINE hn::Vec<hn::RebindToUnsigned<D>> coarsely_known(D d, const CoarseMargins<D, fused>& m,
                                                                const CoarseLimits<D, fused>& limits) {
  using T = Lanes<D, fused>;
  const auto all = hn::Eq(hn::Zero(d), hn::Zero(d));
  auto known = hn::Zero(hn::RebindToUnsigned<D>());
  const auto sides_of = [&](const T& side, const T& degree, AxisMasks<D>& axis) HWY_ATTR {
    axis.sides = hn::Gt(side.v, degree.v);
    axis.fails = hn::Or(axis.fails, hn::Lt(side.v, hn::Neg(degree.v)));
  };
  const auto radius = [&](const T& margin, const T& degree) HWY_ATTR {
    return AxisMasks<D>{hn::Gt(margin.v, degree.v), all, hn::Lt(margin.v, hn::Neg(degree.v))};
  };
  for (int i = 0; i < 3; ++i) {
    AxisMasks<D> vertex = radius(m.vertex[i].radius, limits.degree2), edge = radius(m.edge[i].radius, limits.degree4);
    sides_of(least(m.vertex[i].away, m.vertex[i].towards), limits.degree2, vertex);
    sides_of(m.edge[i].side, limits.degree4, edge);
    note(d, vertex, KnownResults::vertex_axis + i, known);
    note(d, edge, KnownResults::edge_axis + i, known);
  }
  note(d, radius(m.plane, limits.degree6), KnownResults::plane_axis, known);
  return known;
}

template <class D, bool fused>
AXISCERT_INLINE DecidedLanes<D> coarse_step(const CoarseMargins<D, fused>& m, const CoarseLimits<D, fused>& limits) {
  using T = Lanes<D, fused>;
  const auto of_vertex = [&](int i) HWY_ATTR {
    return least(least(m.vertex[i].radius, m.vertex[i].away), m.vertex[i].towards);
  };
  const auto of_edge = [&](int i) HWY_ATTR { return least(m.edge[i].radius, m.edge[i].side); };
  const T vertices = greatest(greatest(of_vertex(0), of_vertex(1)), of_vertex(2));
  const T edges = greatest(greatest(of_edge(0), of_edge(1)), of_edge(2));
  const auto in_range = limits.in_range(m.S, m.r);
  return {hn::And(in_range, limits.any_beyond(vertices, edges, m.plane)),
          hn::And(in_range, limits.all_within(vertices, edges, m.plane))};
}
template <class D, bool fused>
AXISCERT_INLINE DecidedLanes<D> coarse_step(D, const Problem<Lanes<D, fused>>& q) {
  const CoarseMargins<D, fused> margins = coarse_margins(q);
  return coarse_step(margins, CoarseLimits<D, fused>(margins.S, margins.E));
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
