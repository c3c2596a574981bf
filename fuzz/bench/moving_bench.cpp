// Nanoseconds per query of each kernel of the moving sphere on each target, verdict only, over 2^17 distinct queries in
// binary32; and of Bullet's btSubsimplexConvexCast, where it is there.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#ifdef AXISCERT_HAS_BULLET
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#endif

#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {
namespace {

constexpr std::size_t query_count = std::size_t{1} << 17;

// Triangle and centre in [-1, 1)^3, D in [-2, 2)^3, r up to 1/4: a third are contacts.
const QueryBatch<float>& queries() {
  static const QueryBatch<float> batch = [] {
    std::mt19937_64 random(1);
    QueryBatch<float> all(query_count, 16);
    for (std::size_t i = 0; i < query_count; ++i) {
      Numbers<float> v(16);
      for (float& x : v) x = static_cast<float>(static_cast<std::int64_t>(random()) >> 11) * 0x1p-52f;
      for (std::size_t k = 12; k < 15; ++k) v[k] *= 2;
      v[15] = std::abs(v[15]) / 4;
      all.push_back(v);
    }
    return all;
  }();
  return batch;
}

void time_verdicts(benchmark::State& state, const std::function<void(const QueryColumns<float>&, Verdict*)>& verdicts) {
  const auto columns = queries().columns();
  std::vector<Verdict> out(query_count);
  for (auto _ : state) {
    verdicts(columns, out.data());
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  std::size_t contacts = 0;
  for (const Verdict verdict : out) contacts += verdict == Verdict::contact;
  state.counters["contacts"] = static_cast<double>(contacts) / static_cast<double>(query_count);
  state.counters["per_query"] = benchmark::Counter(
      static_cast<double>(query_count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

#ifdef AXISCERT_HAS_BULLET
void by_bullet(const QueryColumns<float>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    const auto vector = [&](std::size_t k) {
      return btVector3(batch.column[k][i], batch.column[k + 1][i], batch.column[k + 2][i]);
    };
    btTriangleShape triangle(vector(0), vector(3), vector(6));
    triangle.setMargin(0);
    btSphereShape sphere(batch.column[15][i]);
    btVoronoiSimplexSolver simplex;
    btSubsimplexConvexCast cast(&sphere, &triangle, &simplex);
    btTransform from = btTransform::getIdentity(), to = from;
    const btTransform stands = from;
    from.setOrigin(vector(9));
    to.setOrigin(vector(9) + vector(12));
    btConvexCast::CastResult result;
    const bool hits = cast.calcTimeOfImpact(from, to, stands, stands, result);
    out[i] = hits ? Verdict::contact : Verdict::separated;
  }
}
#endif

const bool added = [] {
  for (const std::string& target : available_targets()) {
    for (const Kernel& kernel : kernels()) {
      if (kernel.predicate != &moving_sphere_predicate()) continue;
      if (target != scalar_target && !kernel.has_simd) continue;
      benchmark::RegisterBenchmark((kernel.id + "/" + target).c_str(), time_verdicts,
                                   kernel.on<float>(target).verdicts);
    }
  }
#ifdef AXISCERT_HAS_BULLET
  benchmark::RegisterBenchmark("Bullet btSubsimplexConvexCast", time_verdicts, by_bullet);
#endif
  return true;
}();

}  // namespace
}  // namespace axiscert
