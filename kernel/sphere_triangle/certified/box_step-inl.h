// A step before the first, where all queries have the same sphere: triangles beyond one face of the sphere's box are
// separated. In a large mesh these are nearly all triangles, and the step takes a quarter of the first step's
// operations. No include guard: included once for each of Highway's instruction sets, after coarse_step-inl.h.
//
// The step is exact, whatever the sizes: low is the number nearest to p - r, so a number below it is below p - r; and
// no number is below it where the difference overflows.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

template <class Real>
AXISCERT_INLINE Real chosen(bool flag, Real yes, Real no) {
  return flag ? yes : no;
}

// If px py pz r is not a valid sphere, nothing is beyond the box. proofs/certified records it over numbers that are
// symbols, so it has no branch.
template <class Real>
struct SphereBox {
  Real low[3], high[3];

  AXISCERT_INLINE SphereBox(Real px, Real py, Real pz, Real r) {
    const Real infinity = std::numeric_limits<float>::infinity();
    const Real p[3] = {px, py, pz};
    const auto is_sphere = (r >= 0) & (((px - px) + (py - py)) + ((pz - pz) + (r - r)) == 0);
    for (int k = 0; k < 3; ++k) {
      low[k] = chosen(is_sphere, p[k] - r, -infinity);
      high[k] = chosen(is_sphere, p[k] + r, infinity);
    }
  }
  // The faces that a vertex is beyond, one bit each: of a sample, so that no answer depends on it.
  AXISCERT_INLINE unsigned beyond(const Real* x) const {
    unsigned faces = 0;
    for (int k = 0; k < 3; ++k) faces |= unsigned{x[k] < low[k]} << 2 * k | unsigned{x[k] > high[k]} << (2 * k + 1);
    return faces;
  }
};

template <class D>
class BoxStep {
 public:
  using T = Lanes<D>;
  using V = hn::Vec<D>;
  using Real = hn::TFromD<D>;

  AXISCERT_INLINE explicit BoxStep(const SphereBox<Real>& box) : box_(box) {}

  // Whether the triangles of all lanes are beyond a face; false where a coordinate is not finite. A sum that overflows
  // also gives false, which does no harm.
  AXISCERT_INLINE bool all_beyond(const Problem<T>& q) const {
    const D d;
    const auto beyond = [&](const T& a, const T& b, const T& c, int k) HWY_ATTR {
      const V greatest = hn::Max(hn::Max(a.v, b.v), c.v), least = hn::Min(hn::Min(a.v, b.v), c.v);
      return hn::Or(hn::Lt(greatest, hn::Set(d, box_.low[k])), hn::Gt(least, hn::Set(d, box_.high[k])));
    };
    const auto any =
        hn::Or(hn::Or(beyond(q.a.x, q.b.x, q.c.x, 0), beyond(q.a.y, q.b.y, q.c.y, 1)), beyond(q.a.z, q.b.z, q.c.z, 2));
    const auto sum = [](const Vec3<T>& v) HWY_ATTR { return (v.x + v.y) + v.z; };
    const T all = (sum(q.a) + sum(q.b)) + sum(q.c);
    return hn::AllTrue(d, hn::And(any, hn::Eq((all - all).v, hn::Zero(d))));
  }

 private:
  SphereBox<Real> box_;
};

// The faces that vertices are beyond, a byte a lane and in it a bit a face. A vertex that is not finite has no bit set.
template <class D>
AXISCERT_INLINE hn::Vec<hn::Rebind<std::uint8_t, D>> outcodes_of(D d, const SphereBox<hn::TFromD<D>>& box, hn::Vec<D> x,
                                                                 hn::Vec<D> y, hn::Vec<D> z) {
  using V = hn::Vec<D>;
  const hn::RebindToUnsigned<D> bits;
  const auto face = [&](hn::Mask<D> beyond, int bit) HWY_ATTR {
    return hn::IfThenElseZero(hn::RebindMask(bits, beyond),
                              hn::Set(bits, static_cast<hn::TFromD<hn::RebindToUnsigned<D>>>(1 << bit)));
  };
  const auto axis = [&](V v, int k) HWY_ATTR {
    return hn::Or(face(hn::Lt(v, hn::Set(d, box.low[k])), 2 * k), face(hn::Gt(v, hn::Set(d, box.high[k])), 2 * k + 1));
  };
  const V sum = hn::Add(hn::Add(x, y), z);  // an overflow clears the bits, which does no harm
  const auto is_finite = hn::RebindMask(bits, hn::Eq(hn::Sub(sum, sum), hn::Zero(d)));
  return hn::TruncateTo(hn::Rebind<std::uint8_t, D>(),
                        hn::IfThenElseZero(is_finite, hn::Or(hn::Or(axis(x, 0), axis(y, 1)), axis(z, 2))));
}

// Whether a triangle is beyond a face, where the first three lanes of a, b and c are a vertex each, and those of low
// and high the box's ends. The fourth lanes are anything.
template <class D4, class V>
AXISCERT_INLINE bool is_beyond(D4 d, V a, V b, V c, V low, V high) {
  const auto xyz = hn::FirstN(d, 3), fourth = hn::Not(xyz);
  const auto beyond = hn::Or(hn::Lt(hn::Max(hn::Max(a, b), c), low), hn::Gt(hn::Min(hn::Min(a, b), c), high));
  const auto sum = hn::Add(hn::Add(a, b), c);
  // Not Ne, which on AVX-512 is false for NaN.
  return hn::AllTrue(d, hn::Or(fourth, hn::Eq(hn::Sub(sum, sum), hn::Zero(d)))) &&
         !hn::AllFalse(d, hn::And(xyz, beyond));
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
