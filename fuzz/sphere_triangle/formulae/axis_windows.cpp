#include "fuzz/sphere_triangle/formulae/axis_windows.h"

#include <cmath>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/unbounded.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/formulae_list.h"

namespace axiscert {
namespace {

constexpr std::size_t reference_count = 256;

// |l - r| >= (l + r) / 32; neither side may be negative.
bool far_apart(const BinaryNumber& l, const BinaryNumber& r) {
  const BinaryNumber difference = (l - r) * BinaryNumber(32), sum = l + r;
  return difference >= sum || -difference >= sum;
}
// |cos(u, v)| >= 1/32.
bool far_from_right_angle(const Vec3<BinaryNumber>& u, const Vec3<BinaryNumber>& v) {
  const BinaryNumber d = dot(u, v) * BinaryNumber(32);
  return d * d >= dot(u, u) * dot(v, v);
}

template <class Real>
QueryBatch<Real> scaled_queries(const std::vector<Query<Real>>& queries, int exponent) {
  QueryBatch<Real> batch(queries.size(), coordinate_count);
  for (const Query<Real>& q : queries) batch.push_back(times_power(q, exponent));
  return batch;
}

// The axes whose bits agree with the unbounded exponent on every query of the batch.
template <class Real>
AxisBits sound_axes(const Kernel& kernel, const Implementation<Real>& implementation, const QueryBatch<Real>& batch,
                    const std::vector<ComparisonBits>& expected) {
  Answers<Real> answers;
  answers.resize(batch.size(), comparison_count);
  implementation.explain(batch.columns(), answers);
  ComparisonBits broken = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    broken |= static_cast<ComparisonBits>(answers.bits[i] ^ expected[i]);
    if (kernel.exposes != Exposure::sides) continue;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      if (!std::isfinite(answers.lhs[k][i]) || !std::isfinite(answers.rhs[k][i])) {
        broken |= one_bit<ComparisonBits>(k);
      }
    }
  }
  AxisBits sound = 0;
  for (std::size_t i = 0; i < axis_count; ++i) {
    if ((broken & axis_comparisons[i]) == 0) sound |= one_bit<AxisBits>(i);
  }
  return sound;
}

}  // namespace

template <class Real>
bool is_far_from_every_change(const Query<Real>& q) {
  const auto t = centred_as<BinaryNumber>(q, [](Real x) { return BinaryNumber(static_cast<double>(x)); });
  const Vec3<BinaryNumber> normal = cross(t.b - t.a, t.c - t.a);
  const BinaryNumber d = dot(t.a, normal);
  if (!far_apart(d * d, t.rr * dot(normal, normal))) return false;
  const Vec3<BinaryNumber> vertices[] = {t.a, t.b, t.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<BinaryNumber>&a = vertices[i], &b = vertices[(i + 1) % 3], &c = vertices[(i + 2) % 3];
    const Vec3<BinaryNumber> along = b - a, edge_normal = cross(a, b);
    // Side comparisons: the angles at the vertex; and the angle between the plane of ABC and the plane of the edge and
    // the centre.
    if (!far_apart(dot(a, a), t.rr) || !far_apart(dot(edge_normal, edge_normal), t.rr * dot(along, along)) ||
        !far_from_right_angle(a, along) || !far_from_right_angle(a, c - a) ||
        !far_from_right_angle(edge_normal, normal)) {
      return false;
    }
  }
  return true;
}
template bool is_far_from_every_change(const Query<float>&);
template bool is_far_from_every_change(const Query<double>&);

template <class Real>
std::vector<Query<Real>> window_queries() {
  const Family& general = find_family("general");
  std::vector<Query<Real>> queries;
  for (std::uint64_t position = 0; queries.size() < reference_count; ++position) {
    const Query<Real> q = general.make<Real>(1, position);
    if (is_far_from_every_change(q)) queries.push_back(q);
  }
  return queries;
}
template std::vector<Query<float>> window_queries<float>();
template std::vector<Query<double>> window_queries<double>();

template <class Real>
AxisWindows exponent_windows(const Kernel& kernel) {
  const std::vector<Query<Real>> queries = window_queries<Real>();
  // Both sides of every comparison are homogeneous, of one degree, and with an unbounded exponent rounding commutes
  // with a scaling by 2^k: these bits hold at every scale.
  std::vector<ComparisonBits> expected;
  for (const Query<Real>& q : queries) {
    expected.push_back(*unbounded(formulae_of(kernel), kernel.arithmetic, kernel.strictness, q).bits);
  }
  const Implementation<Real> implementation = kernel.on<Real>(scalar_target);
  const auto sound_at = [&](int m) { return sound_axes(kernel, implementation, scaled_queries(queries, m), expected); };
  AxisWindows windows;
  const AxisBits at_zero = sound_at(0);
  for_each_bit(at_zero, [&](std::size_t i) { windows[i] = ExponentWindow{0, 0}; });
  const ExponentWindow scanned = scanned_exponents(precision_of<Real>);
  AxisBits sound = at_zero;
  for (int m = 1; m <= scanned.high && sound != 0; ++m) {
    sound &= sound_at(m);
    for_each_bit(sound, [&](std::size_t i) { windows[i]->high = m; });
  }
  sound = at_zero;
  for (int m = -1; m >= scanned.low && sound != 0; --m) {
    sound &= sound_at(m);
    for_each_bit(sound, [&](std::size_t i) { windows[i]->low = m; });
  }
  return windows;
}
template AxisWindows exponent_windows<float>(const Kernel&);
template AxisWindows exponent_windows<double>(const Kernel&);

}  // namespace axiscert
