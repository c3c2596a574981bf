// A kernel that takes whole batches: the published test as a loop over axiscert's structure of arrays, which the
// compiler turns into vector instructions; float and double from one template. It gives its sixteen comparisons, so
// that each of them is judged, and not only the verdict.
#include <axiscert/plugin.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace {

template <class Real>
struct Vec {
  Real x, y, z;
  friend Vec operator-(Vec u, Vec v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  friend Vec operator*(Vec u, Real s) { return {u.x * s, u.y * s, u.z * s}; }
};
template <class Real>
Real dot(Vec<Real> u, Vec<Real> v) {
  return (u.x * v.x + u.y * v.y) + u.z * v.z;
}
template <class Real>
Vec<Real> cross(Vec<Real> u, Vec<Real> v) {
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// The comparisons of one query, 2^i for comparison i, in the order of plugin.h. The vertices are relative to the
// centre; rr is the squared radius. There is no branch and one width throughout, including the sum (which is exact), so
// a loop over this becomes vector instructions on any target.
template <class Real>
Real comparisons(Vec<Real> A, Vec<Real> B, Vec<Real> C, Real rr) {
  const Vec<Real> AB = B - A, BC = C - B, CA = A - C, V = cross(AB, C - A);
  const Real d = dot(A, V), e = dot(V, V);
  const Real aa = dot(A, A), ab = dot(A, B), ac = dot(A, C), bb = dot(B, B), bc = dot(B, C), cc = dot(C, C);
  const Real e1 = dot(AB, AB), e2 = dot(BC, BC), e3 = dot(CA, CA);
  // The foot of the centre on each edge's line, times the squared length of the edge.
  const Vec<Real> Q1 = A * e1 - AB * (ab - aa), Q2 = B * e2 - BC * (bc - bb), Q3 = C * e3 - CA * (ac - cc);

  Real bits = 0;
  const auto holds = [&bits](int i, Real lhs, Real rhs) { bits += lhs > rhs ? static_cast<Real>(1 << i) : 0; };
  holds(0, d * d, rr * e);
  holds(1, aa, rr), holds(2, ab, aa), holds(3, ac, aa);
  holds(4, bb, rr), holds(5, ab, bb), holds(6, bc, bb);
  holds(7, cc, rr), holds(8, ac, cc), holds(9, bc, cc);
  holds(10, dot(Q1, Q1), rr * e1 * e1), holds(11, dot(Q1, C * e1 - Q1), 0);
  holds(12, dot(Q2, Q2), rr * e2 * e2), holds(13, dot(Q2, A * e2 - Q2), 0);
  holds(14, dot(Q3, Q3), rr * e3 * e3), holds(15, dot(Q3, B * e3 - Q3), 0);
  return bits;
}

// An axis separates if all of its comparisons hold, and the sphere is clear of the triangle if any axis separates.
bool separated(unsigned bits) {
  constexpr unsigned axes[] = {0x0001, 0x000e, 0x0070, 0x0380, 0x0c00, 0x3000, 0xc000};
  return std::any_of(std::begin(axes), std::end(axes), [bits](unsigned axis) { return (bits & axis) == axis; });
}

template <class Real>
void run(const axiscert_batch* batch, const axiscert_answers* answers) {
  const Real* column[13];
  for (int k = 0; k < 13; ++k) column[k] = static_cast<const Real*>(batch->column[k]);

  constexpr std::size_t block = 64;
  for (std::size_t first = 0; first < batch->count; first += block) {
    // The loop never reads beyond the arrays, which end where the batch does.
    const std::size_t count = std::min(block, batch->count - first);
    Real sums[block];
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t i = first + j;
      const auto point = [&](int k) { return Vec<Real>{column[k][i], column[k + 1][i], column[k + 2][i]}; };
      const Vec<Real> p = point(9);
      const Real r = column[12][i];
      sums[j] = comparisons(point(0) - p, point(3) - p, point(6) - p, r * r);
    }
    for (std::size_t j = 0; j < count; ++j) {
      const auto bits = static_cast<std::uint32_t>(sums[j]);
      answers->verdict[first + j] = separated(bits) ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
      if (answers->comparisons) answers->comparisons[first + j] = bits;  // null where only verdicts are asked for
    }
  }
}

template <class Real>
constexpr axiscert_kernel kernel = {
    .abi = AXISCERT_PLUGIN_ABI,
    .precision = 8 * sizeof(Real),
    .size = sizeof(axiscert_kernel),
    .name = "batch-kernel",
    .column_count = 13,
    .run = run<Real>,
    .predicate = nullptr,  // sphere-triangle
    .entry = nullptr,      // the one that it has
    .summary = "the published test as a vectorized loop",
    .source = AXISCERT_SOURCE,
    .exposes = AXISCERT_COMPARISONS,
    .touching = AXISCERT_TOUCHING_IS_CONTACT,
    .measure_count = 0,
    // A kernel that means to equal a built-in one bit for bit names it here; any difference is then its fault.
    .conforms_to = nullptr,
    // This kernel evaluates the published formulae in its own way: its comparisons are compared with their exact
    // values.
    .formulae = "published",
    .limits = nullptr,                    // none: it is meant to be right everywhere
    .start = AXISCERT_START_IS_REPORTED,  // this and the next two are for tests of motions
    .still = AXISCERT_STILL_IS_REPORTED,
    .sides = AXISCERT_BOTH_SIDES,
    .may_decline = 0,  // it answers every valid query
};

}  // namespace

// Called with 0, 1, ... until it returns null: one kernel per precision.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  switch (index) {
    case 0:
      return &kernel<float>;
    case 1:
      return &kernel<double>;
    default:
      return nullptr;
  }
}
