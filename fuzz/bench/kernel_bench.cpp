// Nanoseconds per query of each kernel on each target, verdict only, over 2^17 distinct queries; and of a
// hand-written loop, with which the scalar reference has to keep up.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::size_t query_count = std::size_t{1} << 17;

template <class Real>
const QueryBatch<Real>& queries() {
  static const QueryBatch<Real> batch = [] {
    std::mt19937_64 random(1);
    QueryBatch<Real> all(query_count, coordinate_count);
    for (std::size_t i = 0; i < query_count; ++i) {
      std::array<Real, coordinate_count> v;
      for (Real& x : v) x = static_cast<Real>(static_cast<std::int64_t>(random()) >> 11) * Real(0x1p-52);
      v[12] = std::abs(v[12]);
      all.push_back(from_coordinates(v));
    }
    return all;
  }();
  return batch;
}

// The article's last block as a user writes it, without templates.
template <class Real>
bool handwritten(const Real* const* k, std::size_t i) {
  const Real px = k[9][i], py = k[10][i], pz = k[11][i], r = k[12][i];
  const Real ax = k[0][i] - px, ay = k[1][i] - py, az = k[2][i] - pz;
  const Real bx = k[3][i] - px, by = k[4][i] - py, bz = k[5][i] - pz;
  const Real cx = k[6][i] - px, cy = k[7][i] - py, cz = k[8][i] - pz;
  const Real rr = r * r;
  const Real ux = bx - ax, uy = by - ay, uz = bz - az, wx = cx - ax, wy = cy - ay, wz = cz - az;
  const Real vx = uy * wz - uz * wy, vy = uz * wx - ux * wz, vz = ux * wy - uy * wx;
  const Real d = ax * vx + ay * vy + az * vz, e = vx * vx + vy * vy + vz * vz;
  const Real aa = ax * ax + ay * ay + az * az, ab = ax * bx + ay * by + az * bz, ac = ax * cx + ay * cy + az * cz;
  const Real bb = bx * bx + by * by + bz * bz, bc = bx * cx + by * cy + bz * cz, cc = cx * cx + cy * cy + cz * cz;
  const auto edge = [rr](Real x, Real y, Real z, Real sx, Real sy, Real sz, Real along, Real ox, Real oy, Real oz) {
    const Real len = sx * sx + sy * sy + sz * sz;
    const Real qx = x * len - sx * along, qy = y * len - sy * along, qz = z * len - sz * along;
    const Real tx = ox * len - qx, ty = oy * len - qy, tz = oz * len - qz;
    return (qx * qx + qy * qy + qz * qz > rr * len * len) & (qx * tx + qy * ty + qz * tz > 0);
  };
  return (d * d > rr * e) | ((aa > rr) & (ab > aa) & (ac > aa)) | ((bb > rr) & (ab > bb) & (bc > bb)) |
         ((cc > rr) & (ac > cc) & (bc > cc)) | edge(ax, ay, az, ux, uy, uz, ab - aa, cx, cy, cz) |
         edge(bx, by, bz, cx - bx, cy - by, cz - bz, bc - bb, ax, ay, az) |
         edge(cx, cy, cz, ax - cx, ay - cy, az - cz, ac - cc, bx, by, bz);
}

template <class Real>
void handwritten_loop(const QueryColumns<Real>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) out[i] = static_cast<Verdict>(handwritten(batch.column.data(), i));
}

template <class Real>
void time_verdicts(benchmark::State& state, const std::function<void(const QueryColumns<Real>&, Verdict*)>& verdicts) {
  const auto columns = queries<Real>().columns();
  std::vector<Verdict> out(query_count);
  for (auto _ : state) {
    verdicts(columns, out.data());
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_query"] = benchmark::Counter(
      static_cast<double>(query_count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class Real>
void add() {
  const std::string precision(name(precision_of<Real>));
  benchmark::RegisterBenchmark(("plain loop/" + precision).c_str(), time_verdicts<Real>, handwritten_loop<Real>);
  for (const std::string& target : available_targets()) {
    for (const Kernel& kernel : kernels()) {
      if (kernel.predicate != &sphere_triangle_predicate()) continue;
      if (target != scalar_target && !kernel.has_simd) continue;
      benchmark::RegisterBenchmark((std::string(kernel.id) + "/" + precision + "/" + target).c_str(),
                                   time_verdicts<Real>, kernel.on<Real>(target).verdicts);
    }
  }
}

const bool added = [] {
  add<float>();
  add<double>();
  return true;
}();

}  // namespace
}  // namespace axiscert
