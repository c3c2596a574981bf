// The formulae without roots for kernel/permitted: those of sums and products, and the methods.
#include "kernel/permitted/recording.h"
#include "kernel/sphere_triangle/reference/formulae_types.h"

namespace axiscert::permitted {
namespace {

using T = RecordedNumber;

portable::Problem<T> problem(auto&& load) {
  const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
  return {vector(0), vector(3), vector(6), vector(9), load(12), T(0.0)};
}

template <class F>
Recording recording(const Permissions& permissions, Strictness strictness) {
  return recorded(permissions, comparison_count, nonstrict_comparisons(strictness), [](auto&& load, auto&& sink) {
    F::comparisons(problem(load),
                   [&](Comparison which, const T& lhs, const T& rhs) { sink(index_of(which), lhs, rhs); });
  });
}

template <Formulae f>
void put(const Kernel& kernel, Recorder& found) {
  using F = FormulaeType<f>;
  if (formulae_of(kernel) != f) return;
  if constexpr (!has_comparisons(f)) {
    found = [](const Permissions& permissions) {
      return recorded_paths(permissions, [](auto&& load) { return F::separated(problem(load)); });
    };
  } else if constexpr (F::is_ring) {
    found = [s = kernel.strictness](const Permissions& permissions) { return recording<F>(permissions, s); };
  }
}

}  // namespace

Recorder sphere_triangle_recorder(const Kernel& kernel) {
  Recorder found;
#define AXISCERT_PUT(name, type, kind) put<Formulae::name>(kernel, found);
  AXISCERT_FORMULAE(AXISCERT_PUT)
#undef AXISCERT_PUT
  return found;
}

}  // namespace axiscert::permitted
