// The formulae that permissions are applied to, as graphs. Each predicate's room records its own.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "kernel/formulae_kernel.h"
#include "kernel/permitted/graph.h"

namespace axiscert::permitted {

struct Recording {
  Graph graph;
  std::vector<std::pair<Value, Value>> sides;  // by comparison; a comparison is lhs > rhs
  ComparisonBits nonstrict = 0;                // those that are lhs >= rhs
};
using Recorder = std::function<Recording(const Permissions&)>;

// The recorder of the formulae that a kernel claims; empty where they are not known here.
Recorder recorder_of(const Kernel& kernel);
Recorder sphere_triangle_recorder(const Kernel& kernel);
Recorder moving_sphere_recorder(const Kernel& kernel);
Recorder box_box_recorder(const Kernel& kernel);

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

// Of formulae as kernel/formulae_kernel.h has them: `found` where the kernel claims them.
template <class Test, class F>
void put_recorder(const Kernel& kernel, Recorder& found) {
  using T = RecordedNumber;
  if (kernel.predicate != &Test::description() || kernel.entry != Test::entry || kernel.formulae != F::name) return;
  found = [](const Permissions& permissions) {
    return recorded(
        permissions, Test::description().comparisons.size(), nonstrict_comparisons<F>(),
        [](auto&& load, auto&& sink) { F::template comparisons<T>(Test::template problem<T>(load), sink); });
  };
}

}  // namespace axiscert::permitted
