// The first step of a contact's numbers, one query a lane; contact_steps.h has the derivation of its bounds. No include
// guard: included once for each of Highway's instruction sets, after ../numbers/pairs-inl.h and ../leftovers-inl.h.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// D is of doubles, Real the type of the input.
template <class D, class Real>
class ContactStep {
 public:
  using T = Lanes<D, false>;  // nothing is fused
  using Mask = hn::Mask<D>;
  using Vector = Vec3<T>;

  Mask measured;          // the feature is certain, and the numbers keep their bounds
  Mask decided, contact;  // the verdict is certain too
  Mask feature[3];        // its binary digits
  T separation;
  Vector normal, point;

  AXISCERT_INLINE explicit ContactStep(const Problem<T>& q) {
    const Vector A = q.a - q.p, AB = q.b - q.a, AC = q.c - q.a;
    const T aa = dot(A, A), g1 = dot(A, AB), g2 = dot(A, AC), f = dot(AB, AC), e1 = dot(AB, AB), e3 = dot(AC, AC);
    const T E = e1 + e3, S = aa + E;
    const T by2 = number(ContactBounds::side_2 * v) * S, by4 = number(ContactBounds::side_4 * v) * (S * E);
    const T g3 = g1 + e1, g6 = g2 + e3, bc = g3 - (g2 + f), cb = g6 - (g1 + f);
    const T beyond_ab = g1 * f - e1 * g2, beyond_ca = f * g2 - g1 * e3;
    const T beyond_bc = (e1 * e3 - f * f) - (beyond_ab + beyond_ca);
    const T minus2 = -by2, minus4 = -by4;

    const Mask on_a = above(least(g1, g2), by2);
    const Mask on_b = above(minus2, greatest(g3, bc)), on_c = above(minus2, greatest(g6, cb));
    const Mask on_ab = hn::And(hn::And(above(minus2, g1), above(g3, by2)), above(minus4, beyond_ab));
    const Mask on_bc = hn::And(above(least(bc, cb), by2), above(minus4, beyond_bc));
    const Mask on_ca = hn::And(hn::And(above(minus2, g2), above(g6, by2)), above(minus4, beyond_ca));
    const Mask on_face = above(least(least(beyond_ab, beyond_bc), beyond_ca), by4);
    const Mask on_vertex = hn::Or(hn::Or(on_a, on_b), on_c), on_edge = hn::Or(hn::Or(on_ab, on_bc), on_ca);
    feature[0] = hn::Or(hn::Or(on_b, on_ab), on_ca);
    feature[1] = hn::Or(hn::Or(on_c, on_ab), on_face);
    feature[2] = hn::Or(hn::Or(on_bc, on_ca), on_face);

    const Vector Q = either(hn::Or(on_c, on_ca), q.c, either(hn::Or(on_b, on_bc), q.b, q.a));
    const Vector to = either(on_ab, q.b, either(on_ca, q.a, q.c));
    const Vector b = Q - q.p, y = to - Q;
    Vector w;
    Mask is_sound;  // the normal that w is made of is accurate
    if constexpr (is_narrow) {
      const Vector along = either(on_face, cross(AB, AC), y);
      const T square = dot(along, along);
      const Vector part = along * T{hn::Div(dot(b, along).v, square.v)};
      w = either(on_vertex, b, either(on_face, part, b - part));
      is_sound = above(square, number(ContactBounds::least_normal_32) * (e1 * e3));
    } else {
      const Vector of = either(on_face, q.b, Q), from = either(on_face, Q, q.p), x = of - from;
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

    const T certain = number(is_narrow ? ContactBounds::certain_32 : ContactBounds::certain_64) * S;
    const Mask is_long = is_narrow ? above(ww, number(ContactBounds::least_edge_32) * S) : is_sound;
    measured =
        hn::And(hn::Or(on_vertex, hn::Or(hn::And(on_face, is_sound), hn::And(on_edge, is_long))), above(ww, certain));
    measured = hn::And(measured, hn::And(hn::Ge(q.r.v, hn::Zero(D())), hn::Le(q.r.v, greatest_number())));
    if constexpr (!is_narrow) {
      measured = hn::And(measured, hn::And(above(E, number(ContactBounds::least_triangle)),
                                           above(number(ContactBounds::greatest_square), S)));
    }
    // So great that it is not 0 as a float.
    const T shown = is_narrow ? certain + number(ContactBounds::least_shown_32) : certain;
    decided = hn::And(measured, above(separation * separation, shown));
    contact = hn::And(decided, hn::Lt(separation.v, hn::Zero(D())));
  }

 private:
  static constexpr double v = 0x1p-53;
  static constexpr bool is_narrow = sizeof(Real) == 4;
  AXISCERT_INLINE static T number(double x) { return {hn::Set(D(), x)}; }
  AXISCERT_INLINE static hn::Vec<D> greatest_number() {
    return hn::Set(D(), static_cast<double>(std::numeric_limits<Real>::max()));
  }
  AXISCERT_INLINE static T magnitude(const T& x) { return {hn::Abs(x.v)}; }
  AXISCERT_INLINE static Mask above(const T& x, const T& y) { return hn::Gt(x.v, y.v); }
  AXISCERT_INLINE static T either(Mask mask, const T& yes, const T& no) { return {hn::IfThenElse(mask, yes.v, no.v)}; }
  AXISCERT_INLINE static Vector either(Mask mask, const Vector& yes, const Vector& no) {
    return {either(mask, yes.x, no.x), either(mask, yes.y, no.y), either(mask, yes.z, no.z)};
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

// D is of doubles.
template <class D, class Real>
class Contacts {
 public:
  Contacts(const Block<Real>& block, Question question, const ContactColumns<Real>& to, BlockContacts& answer) noexcept
      : block_(block), question_(question), to_(to), answer_(answer) {}

  HWY_NOINLINE void run() noexcept {
    for (std::size_t first = 0; first < block_.size; first += 64) {
      take_word(first, block_.size - first < 64 ? block_.size - first : 64);
    }
    if (unsure_count_ != 0) settle_verdicts(block_, unsure_, unsure_count_, question_, to_, answer_);
  }

 private:
  static constexpr std::size_t lanes = hn::MaxLanes(D());

  // Of up to 64 queries, a bit each.
  struct Word {
    std::uint64_t contact = 0, measured = 0, decided = 0, feature[3] = {};
  };

  AXISCERT_INLINE void take_word(std::size_t first, std::size_t size) noexcept {
    Word found;
    std::size_t i = 0;
    for (; i + lanes <= size; i += lanes) take_vector(block_, first + i, to_, first + i, i, found);
    if (i < size) {
      const Tail<Real, lanes> tail(block_, first + i);
      Real room[7][lanes];
      take_vector(tail.block, 0, {room[0], {room[1], room[2], room[3]}, {room[4], room[5], room[6]}}, 0, i, found);
      for (std::size_t k = 0; k < 7; ++k) std::memcpy(column(k) + first + i, room[k], (size - i) * sizeof(Real));
    }
    const std::size_t word = first / 64;
    const std::uint64_t measured = found.measured & low_bits(size);
    answer_.contact[word] = found.contact & measured;
    for (int k = 0; k < 3; ++k) answer_.feature[k][word] = found.feature[k] & measured;
    for (std::uint64_t rest = measured & ~found.decided; rest != 0; rest &= rest - 1) {
      unsure_[unsure_count_++] = static_cast<std::uint16_t>(first + first_bit(rest));
    }
    if (const std::uint64_t open = low_bits(size) & ~measured; open != 0) settle(open, first);
  }

  Real* column(std::size_t k) const noexcept {
    return k == 0 ? to_.separation : k < 4 ? to_.normal[k - 1] : to_.point[k - 4];
  }

  // Takes the queries at `at` of a block; their numbers go to `place` of the columns, their bits to `shift` of the
  // word.
  AXISCERT_INLINE static void take_vector(const Block<Real>& from, std::size_t at, const ContactColumns<Real>& to,
                                          std::size_t place, std::size_t shift, Word& found) noexcept {
    const D d;
    const ContactStep<D, Real> step(load<false>(d, from, at));
    const auto store = [&](const Lanes<D, false>& x, Real* out) HWY_ATTR {
      if constexpr (sizeof(Real) == 8) hn::StoreU(x.v, d, out + place);
      else hn::StoreU(hn::DemoteTo(hn::Rebind<float, D>(), x.v), hn::Rebind<float, D>(), out + place);
    };
    store(step.separation, to.separation);
    store(step.normal.x, to.normal[0]);
    store(step.normal.y, to.normal[1]);
    store(step.normal.z, to.normal[2]);
    store(step.point.x, to.point[0]);
    store(step.point.y, to.point[1]);
    store(step.point.z, to.point[2]);
    found.contact |= bits_of(d, step.contact) << shift;
    found.measured |= bits_of(d, step.measured) << shift;
    found.decided |= bits_of(d, step.decided) << shift;
    for (int k = 0; k < 3; ++k) found.feature[k] |= bits_of(d, step.feature[k]) << shift;
  }
  HWY_NOINLINE void settle(std::uint64_t open, std::size_t i) noexcept {
    for (; open != 0; open &= open - 1) {
      const std::size_t at = i + first_bit(open);
      double q[13];
      widen(block_, at, q);
      settle_contact(q, question_, at, to_, answer_);
    }
  }

  const Block<Real>& block_;
  const Question question_;
  const ContactColumns<Real>& to_;
  std::uint16_t unsure_[block_size];  // queries that lack their verdict alone
  std::size_t unsure_count_ = 0;
  BlockContacts& answer_;
};

template <class D, class Real>
void decide_contacts(const Block<Real>& block, Question question, const ContactColumns<Real>& to,
                     BlockContacts& answer) noexcept {
  answer = {};
  Contacts<D, Real>(block, question, to, answer).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
