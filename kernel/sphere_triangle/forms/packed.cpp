#include "kernel/sphere_triangle/forms/pair_forms.h"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "kernel/sphere_triangle/forms/scalar_kernel.h"

namespace axiscert {
namespace {

// Four lanes in the compiler's own vector type, which uses at least SSE registers wherever this is compiled.
template <class Real>
using Four [[gnu::vector_size(4 * sizeof(Real))]] = Real;

template <class Real>
struct Lanes {
  Four<Real> v;
  friend Lanes operator+(const Lanes& a, const Lanes& b) { return {a.v + b.v}; }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return {a.v - b.v}; }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return {a.v * b.v}; }
};

template <class Real>
Vec3<Lanes<Real>> lanes(const Vec3<Real>& a, const Vec3<Real>& b, const Vec3<Real>& c, const Vec3<Real>& d) {
  return {{Four<Real>{a.x, b.x, c.x, d.x}}, {Four<Real>{a.y, b.y, c.y, d.y}}, {Four<Real>{a.z, b.z, c.z, d.z}}};
}

// The comparison in each lane of each of the four compares.
using enum Comparison;
constexpr Comparison layout[4][4] = {
    {vertex_a_radius, vertex_b_radius, vertex_c_radius, plane_radius},
    {vertex_a_side_b, vertex_b_side_c, vertex_c_side_a, edge_ab_radius},
    {vertex_a_side_c, vertex_b_side_a, vertex_c_side_b, edge_bc_radius},
    {edge_ab_side_c, edge_bc_side_a, edge_ca_side_b, edge_ca_radius},
};

template <class Real>
struct PackedSides {
  Four<Real> lhs[4], rhs[4];
};

// The three vertices, and the three edges, are side by side in lanes 0 to 2.
template <class Real>
PackedSides<Real> packed_sides(const Query<Real>& q) {
  const Vec3<Real> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p;
  const Real rr = q.r * q.r;
  const Vec3<Real> V = cross(B - A, C - A);
  const Real d = dot(A, V), e = dot(V, V);

  const auto from = lanes(A, B, C, A), to = lanes(B, C, A, A), opposite = lanes(C, A, B, A), along = to - from;
  const Lanes<Real> radius{Four<Real>{rr, rr, rr, rr}};
  const Four<Real> zero{};
  const Lanes<Real> squares = dot(from, from);  // aa, bb, cc
  const Lanes<Real> products = dot(from, to);   // ab, bc, ca
  const Lanes<Real> t = products - squares, lengths = dot(along, along);
  const auto Q = from * lengths - along * t;
  const Lanes<Real> distances = dot(Q, Q), bounds = portable::times_square(radius, lengths);
  const Lanes<Real> sides = dot(Q, opposite * lengths - Q);

  PackedSides<Real> packed{{squares.v, products.v, {products.v[2], products.v[0], products.v[1], 0}, sides.v},
                           {radius.v, squares.v, squares.v, zero}};
  packed.lhs[0][3] = d * d;
  packed.rhs[0][3] = rr * e;
  for (int i = 0; i < 3; ++i) {
    packed.lhs[i + 1][3] = distances.v[i];
    packed.rhs[i + 1][3] = bounds.v[i];
  }
  return packed;
}

// Bit k: lhs > rhs in lane k.
template <class Real>
unsigned greater_mask(const Four<Real>& lhs, const Four<Real>& rhs) {
#if defined(__SSE2__)
  if constexpr (sizeof(Real) == 4) {
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(lhs > rhs)));
  } else {
    const auto half = [&](int k) {
      return static_cast<unsigned>(
          _mm_movemask_pd(_mm_cmpgt_pd(__m128d{lhs[k], lhs[k + 1]}, __m128d{rhs[k], rhs[k + 1]})));
    };
    return half(0) | half(2) << 2;
  }
#else
  unsigned mask = 0;
  for (int k = 0; k < 4; ++k) mask |= static_cast<unsigned>(lhs[k] > rhs[k]) << k;
  return mask;
#endif
}

// For each compare and each mask, the comparisons that hold.
constexpr auto bits_of_mask = [] {
  std::array<std::array<ComparisonBits, 16>, 4> bits{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (unsigned mask = 0; mask < 16; ++mask) {
      for (std::size_t k = 0; k < 4; ++k) {
        if (has_bit(mask, k)) bits[i][mask] |= one_bit<ComparisonBits>(layout[i][k]);
      }
    }
  }
  return bits;
}();

template <Strictness strictness, class Real>
ComparisonBits packed_bits(const PackedSides<Real>& sides) {
  ComparisonBits bits = bits_of_mask[0][greater_mask<Real>(sides.lhs[0], sides.rhs[0])];
  for (std::size_t i = 1; i < 4; ++i) {
    unsigned mask = greater_mask<Real>(sides.lhs[i], sides.rhs[i]);
    // Lanes 0 to 2 are side comparisons; the last lane is a radius comparison, which stays strict.
    if (strictness != Strictness::strict) mask = (mask & 8u) | (~greater_mask<Real>(sides.rhs[i], sides.lhs[i]) & 7u);
    bits |= bits_of_mask[i][mask];
  }
  return bits;
}

template <Strictness strictness, class Real>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    out[i] = verdict_of(axes_of(packed_bits<strictness>(packed_sides(query_at(batch, i)))));
  }
}

template <Strictness strictness, class Real>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    const PackedSides<Real> sides = packed_sides(query_at(batch, i));
    out.bits[i] = packed_bits<strictness>(sides);
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 4; ++k) {
        out.lhs[index_of(layout[j][k])][i] = sides.lhs[j][k];
        out.rhs[index_of(layout[j][k])][i] = sides.rhs[j][k];
      }
    }
  }
}

}  // namespace

template <Strictness strictness, class Real>
Implementation<Real> packed_implementation() {
  return {verdicts<strictness, Real>, explain<strictness, Real>};
}
template Implementation<float> packed_implementation<Strictness::strict, float>();
template Implementation<double> packed_implementation<Strictness::strict, double>();
template Implementation<float> packed_implementation<Strictness::not_less, float>();
template Implementation<double> packed_implementation<Strictness::not_less, double>();

}  // namespace axiscert
