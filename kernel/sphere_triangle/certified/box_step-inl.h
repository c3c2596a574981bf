// A step before the first, where all queries have the same sphere: triangles beyond one face of the sphere's box are
// separated. In a large mesh these are nearly all triangles, and the step takes a quarter of the first step's
// operations. No include guard: included once for each of Highway's instruction sets, after coarse_step-inl.h.
//
// The step is exact, whatever the sizes: low is the number nearest to p - r, so a number below it is below p - r; and
// no number is below it where the difference overflows.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// If px py pz r is not a valid sphere, nothing is beyond the box.
template <class Real>
struct SphereBox {
  Real low[3], high[3];

  AXISCERT_INLINE SphereBox(Real px, Real py, Real pz, Real r) {
    constexpr Real infinity = std::numeric_limits<Real>::infinity();
    const Real p[3] = {px, py, pz};
    const bool is_sphere = r >= 0 && ((px - px) + (py - py)) + ((pz - pz) + (r - r)) == 0;
    for (int k = 0; k < 3; ++k) {
      low[k] = is_sphere ? p[k] - r : -infinity;
      high[k] = is_sphere ? p[k] + r : infinity;
    }
  }
  // The faces that a vertex is beyond, one bit each.
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

  AXISCERT_INLINE BoxStep(Real px, Real py, Real pz, Real r) : box_(px, py, pz, r) {}

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

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
