#include "fuzz/diagnosis/scenes/near_ties.h"

#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/diagnosis/scenes/scenes.h"
#include "fuzz/queries/boundary.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert::diagnosis {

template <class Real>
Query<Real> random_scene(Stream& random) {
  const auto point = [&] {
    const Real x = random.symmetric<Real>(), y = random.symmetric<Real>(), z = random.symmetric<Real>();
    return Vec3<Real>{x, y, z};
  };
  const Vec3<Real> a = point(), b = point(), c = point(), p = point();
  return {a, b, c, p, 0};
}

template <class Real>
Query<Real> near_tie(std::uint64_t seed, std::string_view probe, std::uint64_t position, std::size_t flat) {
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
Queries<Real> sharp_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  if (kernel.test == &first_test()) {
    for (std::uint64_t i = 0; i < count; ++i) queries.push_back(near_tie<Real>(seed, "sharp", i));
    return queries;
  }
  std::vector<const Family*> families;
  for (const Family* family : families_of(*kernel.test)) {
    if (family->entry == kernel.entry && image_group(family->name) == nullptr) families.push_back(family);
  }
  for (std::uint64_t i = 0; i < count && !families.empty(); ++i) {
    queries.push_back(families[i % families.size()]->make<Real>(seed, i / families.size()));
  }
  return queries;
}

template <class Real>
Queries<Real> plain_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  const Family* family = plain_family(kernel);
  for (std::uint64_t i = 0; i < count && family; ++i) queries.push_back(family->make<Real>(seed, i));
  return queries;
}

#define AXISCERT_INSTANCES(Real)                                                                    \
  template Query<Real> random_scene<Real>(Stream&);                                                 \
  template Query<Real> near_tie<Real>(std::uint64_t, std::string_view, std::uint64_t, std::size_t); \
  template Queries<Real> sharp_queries<Real>(const Kernel&, std::uint64_t, std::size_t);            \
  template Queries<Real> plain_queries<Real>(const Kernel&, std::uint64_t, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
