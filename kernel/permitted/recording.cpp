#include "kernel/permitted/recording.h"

#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/sphere_triangle/reference/formulae_types.h"

namespace axiscert::permitted {
namespace {

// Runs `evaluate(load, sink)` over numbers that record.
template <class Evaluate>
Recording recorded(const Permissions& permissions, std::size_t comparisons, ComparisonBits nonstrict,
                   Evaluate&& evaluate) {
  Recording made{Graph(permissions), std::vector<std::pair<Value, Value>>(comparisons), nonstrict};
  RecordedNumber::graph = &made.graph;
  evaluate([&](std::size_t k) { return RecordedNumber(made.graph.input(k)); },
           [&](std::size_t i, const RecordedNumber& lhs, const RecordedNumber& rhs) {
             made.sides[i] = {lhs.value, rhs.value};
           });
  RecordedNumber::graph = nullptr;
  return made;
}

template <class F>
Recording still_recording(const Permissions& permissions, Strictness strictness) {
  using T = RecordedNumber;
  return recorded(permissions, comparison_count, nonstrict_comparisons(strictness), [](auto&& load, auto&& sink) {
    const auto vector = [&](std::size_t k) { return portable::Vec3<T>{load(k), load(k + 1), load(k + 2)}; };
    const portable::Problem<T> problem{vector(0), vector(3), vector(6), vector(9), load(12), T(0.0)};
    F::comparisons(problem, [&](Comparison which, const T& lhs, const T& rhs) { sink(index_of(which), lhs, rhs); });
  });
}

template <class Test, class F>
Recording recording(const Permissions& permissions) {
  using T = RecordedNumber;
  return recorded(permissions, Test::description().comparisons.size(), nonstrict_comparisons<F>(),
                  [](auto&& load, auto&& sink) { F::template comparisons<T>(Test::template problem<T>(load), sink); });
}

template <Formulae f>
void put_still(const Kernel& kernel, std::function<Recording(const Permissions&)>& found) {
  using F = FormulaeType<f>;
  if constexpr (has_comparisons(f)) {
    if constexpr (F::is_ring) {
      if (formulae_of(kernel) == f)
        found = [s = kernel.strictness](const Permissions& p) { return still_recording<F>(p, s); };
    }
  }
}

template <class Test, class F>
void put(const Kernel& kernel, std::function<Recording(const Permissions&)>& found) {
  if (kernel.predicate == &Test::description() && kernel.entry == Test::entry && kernel.formulae == F::name)
    found = recording<Test, F>;
}

}  // namespace

std::function<Recording(const Permissions&)> recorder_of(const Kernel& kernel) {
  std::function<Recording(const Permissions&)> found;
#define AXISCERT_PUT(name, type, kind) put_still<Formulae::name>(kernel, found);
  AXISCERT_FORMULAE(AXISCERT_PUT)
#undef AXISCERT_PUT
  put<MovingSphere, portable::Twenty>(kernel, found);
  put<MovingSphere, portable::TwentyNonstrict>(kernel, found);
  put<boxes::MatrixBoxes, boxes::ProjectedFifteen>(kernel, found);
  put<boxes::MatrixBoxes, boxes::Textbook>(kernel, found);
  put<boxes::MatrixBoxes, boxes::Cofactor>(kernel, found);
  return found;
}

}  // namespace axiscert::permitted
