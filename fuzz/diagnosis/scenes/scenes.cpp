#include "fuzz/diagnosis/scenes/scenes.h"

#include "fuzz/diagnosis/scenes/clear_queries.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert::diagnosis {

const DiagnosisScenes& diagnosis_scenes(const Predicate& predicate) {
  static const DiagnosisScenes by_trait;
  const DiagnosisScenes* own = capabilities_of(predicate).diagnosis_scenes;
  return own ? *own : by_trait;
}

template <class Real>
Queries<Real> sharp_queries(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  if (const auto near_tie = scenes_of<Real>(*kernel.predicate).near_tie) {
    for (std::uint64_t i = 0; i < count; ++i) queries.push_back(near_tie(seed, "sharp", i, no_axis));
    return queries;
  }
  std::vector<const Family*> families;
  for (const Family* family : families_of(*kernel.predicate)) {
    if (family->entry == kernel.entry && image_group(family->name) == nullptr) families.push_back(family);
  }
  for (std::uint64_t i = 0; i < count && !families.empty(); ++i) {
    queries.push_back(families[i % families.size()]->make<Real>(seed, i / families.size()));
  }
  return queries;
}

template <class Real>
Queries<Real> queries_of_general(const Kernel& kernel, std::uint64_t seed, std::size_t count) {
  Queries<Real> queries;
  const Family* family = family_named_general(kernel);
  for (std::uint64_t i = 0; i < count && family; ++i) queries.push_back(family->make<Real>(seed, i));
  return queries;
}

#define AXISCERT_INSTANCES(Real)                                                         \
  template Queries<Real> sharp_queries<Real>(const Kernel&, std::uint64_t, std::size_t); \
  template Queries<Real> queries_of_general<Real>(const Kernel&, std::uint64_t, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::diagnosis
