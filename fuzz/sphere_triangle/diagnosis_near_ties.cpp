// Scenes with full significands, on which the last bit decides or none does.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/steps.h"
#include "fuzz/sphere_triangle/diagnosis_scenes.h"
#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::diagnosis {
namespace {

// Four points with full significands in (-1, 1), the radius 0.
template <class Real>
Query<Real> random_scene(Stream& random) {
  const auto point = [&] {
    const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
    return Vec3<Real>{x, y, z};
  };
  const Vec3<Real> a = point(), b = point(), c = point(), p = point();
  return {a, b, c, p, 0};
}

}  // namespace

template <class Real>
std::vector<ClearQuery<Real>> clear_window_queries(const Kernel& kernel, std::size_t count) {
  std::vector<ClearQuery<Real>> found;
  const Oracles& oracles = oracles_of(kernel);
  for (const Query<Real>& q : window_queries<Real>()) {
    if (found.size() < count) found.push_back({q, oracles.truth(Numbers<Real>(q)).verdict});
  }
  return found;
}

template <class Real>
Numbers<Real> sphere_near_tie(std::uint64_t seed, std::string_view probe, std::uint64_t position, std::size_t flat) {
  Stream random = stream_of(seed, probe, precision_of<Real>, position);
  for (;;) {
    Query<Real> q = random_scene<Real>(random);
    for (Vec3<Real>* point : {&q.a, &q.b, &q.c, &q.p}) {
      if (flat < 3) *std::array<Real*, 3>{&point->x, &point->y, &point->z}[flat] = 0;
    }
    q.r = step_radius(radius_at_distance(q), static_cast<int>(random.integer(-2, 2)));
    if (q.r > Real(0x1p-10)) return q;
  }
}

template <class Real>
TurningScenes<Real> plump_scenes(Subject<Real>& subject, std::size_t count) {
  TurningScenes<Real> scenes{{}, coordinate_count - 1, {}, {}, "the vertices", "the centre"};
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    scenes.is_of_first.push_back(k < 9);
    scenes.is_of_second.push_back(k >= 9 && k < 12);
  }
  for (std::uint64_t position = 0; scenes.queries.size() < count; ++position) {
    Stream random = stream_of(subject.seed(), "turning", precision_of<Real>, position);
    Query<Real> q = random_scene<Real>(random);
    q.r = radius_at_distance(q);
    const Vec3<Real> ab = q.b - q.a, ac = q.c - q.a, bc = q.c - q.b, normal = cross(ab, ac);
    const Real longest = std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)});
    if (q.r < Real(0.125) || dot(normal, normal) < Real(0.0625) * longest * longest) continue;
    scenes.queries.push_back(q);
  }
  return scenes;
}

#define AXISCERT_INSTANCES(Real)                                                                             \
  template std::vector<ClearQuery<Real>> clear_window_queries<Real>(const Kernel&, std::size_t);             \
  template Numbers<Real> sphere_near_tie<Real>(std::uint64_t, std::string_view, std::uint64_t, std::size_t); \
  template TurningScenes<Real> plump_scenes(Subject<Real>&, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
