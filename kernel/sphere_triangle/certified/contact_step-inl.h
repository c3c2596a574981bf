// The first steps of a contact's numbers, one query a lane; contact_steps.h has the derivation of their bounds. No
// include guard: included once for each of Highway's instruction sets, after pairs-inl.h and
// leftovers-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Which part is nearest, by signs that are certain: where none of the masks holds, one is not.
template <class D>
struct NearestPart {
  using T = Lanes<D, false>;  // nothing is fused
  using Mask = hn::Mask<D>;
  using Vector = Vec3<T>;

  Vector AB, AC;
  T e1, e3, E, S;
  Mask on_b, on_c, on_ab, on_bc, on_ca, on_vertex, on_edge, on_face;

  AXISCERT_INLINE explicit NearestPart(const Problem<T>& q) : AB(q.b - q.a), AC(q.c - q.a) {
    constexpr double v = unit_roundoff<hn::TFromD<D>>;
    const Vector A = q.a - q.p;
    const T aa = dot(A, A), g1 = dot(A, AB), g2 = dot(A, AC), f = dot(AB, AC);
    e1 = dot(AB, AB), e3 = dot(AC, AC);
    E = e1 + e3, S = aa + E;
    const T by2 = number(ContactBounds::side_2 * v) * S, by4 = number(ContactBounds::side_4 * v) * (S * E);
    const T g3 = g1 + e1, g6 = g2 + e3, bc = g3 - (g2 + f), cb = g6 - (g1 + f);
    const T beyond_ab = g1 * f - e1 * g2, beyond_ca = f * g2 - g1 * e3;
    const T beyond_bc = (e1 * e3 - f * f) - (beyond_ab + beyond_ca);
    const T minus2 = -by2, minus4 = -by4;

    on_b = above(minus2, greatest(g3, bc)), on_c = above(minus2, greatest(g6, cb));
    on_ab = hn::And(hn::And(above(minus2, g1), above(g3, by2)), above(minus4, beyond_ab));
    on_bc = hn::And(above(least(bc, cb), by2), above(minus4, beyond_bc));
    on_ca = hn::And(hn::And(above(minus2, g2), above(g6, by2)), above(minus4, beyond_ca));
    on_face = above(least(least(beyond_ab, beyond_bc), beyond_ca), by4);
    on_vertex = hn::Or(hn::Or(above(least(g1, g2), by2), on_b), on_c);
    on_edge = hn::Or(hn::Or(on_ab, on_bc), on_ca);
  }
  // A binary digit of the feature.
  AXISCERT_INLINE Mask digit(int k) const {
    return k == 0   ? hn::Or(hn::Or(on_b, on_ab), on_ca)
           : k == 1 ? hn::Or(hn::Or(on_c, on_ab), on_face)
                    : hn::Or(hn::Or(on_bc, on_ca), on_face);
  }
  // The vertex, the ends of the edge, or A and C.
  AXISCERT_INLINE Vector first(const Problem<T>& q) const {
    return either(hn::Or(on_c, on_ca), q.c, either(hn::Or(on_b, on_bc), q.b, q.a));
  }
  AXISCERT_INLINE Vector second(const Problem<T>& q) const { return either(on_ab, q.b, either(on_ca, q.a, q.c)); }

  AXISCERT_INLINE static T number(double x) { return {hn::Set(D(), static_cast<hn::TFromD<D>>(x))}; }
  AXISCERT_INLINE static Mask above(const T& x, const T& y) { return hn::Gt(x.v, y.v); }
  AXISCERT_INLINE static T either(Mask mask, const T& yes, const T& no) { return {hn::IfThenElse(mask, yes.v, no.v)}; }
  AXISCERT_INLINE static Vector either(Mask mask, const Vector& yes, const Vector& no) {
    return {either(mask, yes.x, no.x), either(mask, yes.y, no.y), either(mask, yes.z, no.z)};
  }
  // 0 <= r, and finite as Real.
  template <class Real>
  AXISCERT_INLINE static Mask is_radius(const T& r) {
    const T greatest_number = number(std::numeric_limits<Real>::max());
    return hn::And(hn::Ge(r.v, hn::Zero(D())), hn::Le(r.v, greatest_number.v));
  }
};

// The vector of binary32, in doubles: from P to the nearest point, by the first and the second place of its part and
// AB.
template <class D>
struct ToNearest {
  using T = Lanes<D, false>;
  Vec3<T> w;
  T square;  // of the edge, or of the normal

  AXISCERT_INLINE ToNearest(const Vec3<T>& first, const Vec3<T>& second, const Vec3<T>& P, const Vec3<T>& AB,
                            hn::Mask<D> on_vertex, hn::Mask<D> on_face) {
    const Vec3<T> b = first - P, y = second - first;
    const Vec3<T> along = NearestPart<D>::either(on_face, cross(AB, y), y);
    square = dot(along, along);
    const Vec3<T> part = along * T{hn::Div(dot(b, along).v, square.v)};
    w = NearestPart<D>::either(on_vertex, b, NearestPart<D>::either(on_face, part, b - part));
  }
};

// In binary32 the signs are in floats, the numbers in doubles. F is of floats, D of doubles, with as many lanes or half
// of them.
template <class F, class D>
class QuickStep {
 public:
  using T = Lanes<F, false>;
  using Mask = hn::Mask<F>;
  using Vector = Vec3<T>;

  Mask measured;          // the feature is certain, and the numbers keep their bounds
  Mask decided, contact;  // the verdict is certain too
  Mask feature[3];        // its binary digits
  T separation;
  Vector normal, point;

  AXISCERT_INLINE explicit QuickStep(const Problem<T>& q) {
    using Part = NearestPart<F>;
    const Part part(q);
    for (int k = 0; k < 3; ++k) feature[k] = part.digit(k);
    const Vector Q = part.first(q), to = part.second(q);
    const std::uint64_t vertices = bits_of(F(), part.on_vertex), faces = bits_of(F(), part.on_face);
    const Half lower = half<0>(q, Q, to, vertices, faces);
    Half upper = lower;
    if constexpr (halves == 2) upper = half<1>(q, Q, to, vertices, faces);
    const auto number = [&](int k) HWY_ATTR {
#if HWY_TARGET != HWY_SCALAR
      if constexpr (halves == 2) return T{hn::Combine(F(), upper.number[k], lower.number[k])};
      else
#endif
        return T{lower.number[k]};
    };
    const T ww = number(0);
    const T zero = Part::number(0);
    separation = number(1);
    normal = Vector{number(2), number(3), number(4)} + Vector{zero, zero, zero};  // no -0
    point = Part::either(part.on_vertex, Q, Vector{number(5), number(6), number(7)});

    const T certain = Part::number(ContactBounds::certain_32) * part.S;
    const T least_square = Part::either(part.on_edge, Part::number(ContactBounds::least_edge_32) * part.S, certain);
    measured = hn::And(hn::Or(hn::Or(part.on_vertex, part.on_edge), part.on_face), Part::above(ww, least_square));
    measured = hn::And(measured, hn::And(Part::above(part.E, Part::number(ContactBounds::least_triangle_32)),
                                         Part::above(Part::number(ContactBounds::greatest_square_32), part.S)));
    measured = hn::And(measured, Part::template is_radius<float>(q.r));
    decided = hn::And(measured, Part::above(separation * separation, certain));
    contact = hn::And(decided, hn::Lt(separation.v, hn::Zero(F())));
  }

 private:
  using Narrow = hn::Rebind<float, D>;
  using Wide = NearestPart<D>;
  static constexpr std::size_t halves = hn::MaxLanes(F()) / hn::MaxLanes(D());
  static_assert(halves == 1 || halves == 2);

  // w.w, the separation, the normal and P + w.
  struct Half {
    hn::Vec<Narrow> number[8];
  };
  template <int which>
  AXISCERT_INLINE static typename Wide::T widened(const T& x) {
#if HWY_TARGET != HWY_SCALAR  // whose vectors have no halves
    if constexpr (halves == 2 && which == 0) return {hn::PromoteTo(D(), hn::LowerHalf(Narrow(), x.v))};
    else if constexpr (halves == 2) return {hn::PromoteTo(D(), hn::UpperHalf(Narrow(), x.v))};
    else
#endif
      return {hn::PromoteTo(D(), x.v)};
  }
  template <int which>
  AXISCERT_INLINE static typename Wide::Vector widened(const Vector& x) {
    return {widened<which>(x.x), widened<which>(x.y), widened<which>(x.z)};
  }
  template <int which>
  AXISCERT_INLINE static hn::Mask<D> mask_of(std::uint64_t lanes) {
    const std::uint64_t bits = lanes >> (which * hn::MaxLanes(D())) & low_bits(hn::MaxLanes(D()));
    return hn::LoadMaskBits(D(), reinterpret_cast<const std::uint8_t*>(&bits));
  }
  template <int which>
  AXISCERT_INLINE static Half half(const Problem<T>& q, const Vector& first, const Vector& second,
                                   std::uint64_t vertices, std::uint64_t faces) {
    const auto Q = widened<which>(first), to = widened<which>(second), P = widened<which>(q.p);
    const auto AB = widened<which>(q.b) - Q;
    const auto w = ToNearest<D>(Q, to, P, AB, mask_of<which>(vertices), mask_of<which>(faces)).w;
    const auto square = dot(w, w);
    const typename Wide::T d{hn::Sqrt(square.v)}, by{hn::Div(hn::Set(D(), -1), d.v)};
    const auto normal = w * by, point = P + w;
    const auto narrowed = [&](const typename Wide::T& x) HWY_ATTR { return hn::DemoteTo(Narrow(), x.v); };
    return {{narrowed(square), narrowed(d - widened<which>(q.r)), narrowed(normal.x), narrowed(normal.y),
             narrowed(normal.z), narrowed(point.x), narrowed(point.y), narrowed(point.z)}};
  }
};

// D is of doubles, Real the type of the input.
template <class D, class Real>
class ContactStep {
 public:
  using T = Lanes<D, false>;  // nothing is fused
  using Mask = hn::Mask<D>;
  using Vector = Vec3<T>;
  using Part = NearestPart<D>;

  Mask measured;          // the feature is certain, and the numbers keep their bounds
  Mask decided, contact;  // the verdict is certain too
  Mask feature[3];        // its binary digits
  T separation;
  Vector normal, point;

  AXISCERT_INLINE explicit ContactStep(const Problem<T>& q) {
    const Part part(q);
    for (int k = 0; k < 3; ++k) feature[k] = part.digit(k);
    const Mask on_vertex = part.on_vertex, on_edge = part.on_edge, on_face = part.on_face;
    const Vector Q = part.first(q), to = part.second(q);
    Vector w;
    Mask is_sound;  // the normal that w is made of is accurate
    if constexpr (is_narrow) {
      const ToNearest<D> nearest(Q, to, q.p, part.AB, on_vertex, on_face);
      w = nearest.w;
      is_sound = above(nearest.square, number(ContactBounds::least_normal_32) * (part.e1 * part.e3));
    } else {
      const Vector b = Q - q.p, y = to - Q, of = either(on_face, q.b, Q), from = either(on_face, Q, q.p), x = of - from;
      const Vector N = accurate_cross(of, from, to, Q);
      const T nn = dot(N, N), yy = dot(y, y);
      const T factor{hn::Div(either(on_face, dot(b, N), number(1)).v, either(on_face, nn, yy).v)};
      w = either(on_vertex, b, either(on_face, N, cross(y, N)) * factor);
      is_sound = hn::And(above(nn, number(ContactBounds::least_normal_64) * (dot(x, x) * yy)),
                         above(nn, number(ContactBounds::least_normal)));
    }
    const T ww = dot(w, w), d{hn::Sqrt(ww.v)};
    separation = d - q.r;
    const T zero = number(0);
    normal = w * T{hn::Div(number(-1).v, d.v)} + Vector{zero, zero, zero};  // no -0
    point = either(on_vertex, Q, q.p + w);

    const T certain = number(is_narrow ? ContactBounds::certain_32 : ContactBounds::certain_64) * part.S;
    const Mask is_long = is_narrow ? above(ww, number(ContactBounds::least_edge_32) * part.S) : is_sound;
    measured =
        hn::And(hn::Or(on_vertex, hn::Or(hn::And(on_face, is_sound), hn::And(on_edge, is_long))), above(ww, certain));
    measured = hn::And(measured, Part::template is_radius<Real>(q.r));
    if constexpr (!is_narrow) {
      measured = hn::And(measured, hn::And(above(part.E, number(ContactBounds::least_triangle)),
                                           above(number(ContactBounds::greatest_square), part.S)));
    }
    // So great that it is not 0 as a float.
    const T shown = is_narrow ? certain + number(ContactBounds::least_shown_32) : certain;
    decided = hn::And(measured, above(separation * separation, shown));
    contact = hn::And(decided, hn::Lt(separation.v, hn::Zero(D())));
  }

 private:
  static constexpr bool is_narrow = sizeof(Real) == 4;
  AXISCERT_INLINE static T number(double x) { return Part::number(x); }
  AXISCERT_INLINE static T magnitude(const T& x) { return {hn::Abs(x.v)}; }
  AXISCERT_INLINE static Mask above(const T& x, const T& y) { return Part::above(x, y); }
  template <class Of>
  AXISCERT_INLINE static Of either(Mask mask, const Of& yes, const Of& no) {
    return Part::either(mask, yes, no);
  }

  // (of - from) x (to - at), as if its differences and products were exact.
  AXISCERT_INLINE static Vector accurate_cross(const Vector& of, const Vector& from, const Vector& to,
                                               const Vector& at) {
    using P = Pairs<D>;
    const auto x = [&](const T& i, const T& j) HWY_ATTR { return P::difference(i.v, j.v); };
    const P ax = x(of.x, from.x), ay = x(of.y, from.y), az = x(of.z, from.z);
    const P bx = x(to.x, at.x), by = x(to.y, at.y), bz = x(to.z, at.z);
    return {minor(ay, bz, az, by), minor(az, bx, ax, bz), minor(ax, by, ay, bx)};
  }
  AXISCERT_INLINE static T minor(const Pairs<D>& a, const Pairs<D>& d, const Pairs<D>& b, const Pairs<D>& c) {
    using P = Pairs<D>;
    const P p = P::two_product(a.hi, d.hi), q = P::two_product(b.hi, c.hi), s = P::difference(p.hi, q.hi);
    const auto low_ad = hn::Add(hn::Mul(a.hi, d.lo), hn::Mul(a.lo, d.hi));
    const auto low_bc = hn::Add(hn::Mul(b.hi, c.lo), hn::Mul(b.lo, c.hi));
    const T sum{hn::Add(s.hi, hn::Add(hn::Sub(low_ad, low_bc), hn::Add(hn::Sub(p.lo, q.lo), s.lo)))};
    return sum.zero_where(above(number(ContactBounds::negligible_component), magnitude(sum)));
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
