// The formulae that permissions are applied to, as graphs. Each predicate's room records its own.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "kernel/formulae_kernel.h"
#include "kernel/permitted/graph.h"

namespace axiscert::permitted {

// A way through formulae that branch: the comparisons that it asks, in order, and what each has to say.
struct Path {
  std::vector<std::pair<std::size_t, bool>> decisions;  // index of the comparison
  ComparisonBits holding = 0, failing = 0;
  bool separates = false;
};

struct Recording {
  Graph graph;
  std::vector<std::pair<Value, Value>> sides = {};  // by comparison; a comparison is lhs > rhs
  ComparisonBits nonstrict = 0;                     // those that are lhs >= rhs
  std::vector<Path> paths = {};  // of formulae that branch: all; else the predicate's clauses make the verdict
};
using Recorder = std::function<Recording(const Permissions&)>;

// The recorder of the formulae that a kernel claims; empty where they are not known here.
Recorder recorder_of(const Kernel& kernel);
Recorder sphere_triangle_recorder(const Kernel& kernel);
Recorder moving_sphere_recorder(const Kernel& kernel);
Recorder capsule_triangle_recorder(const Kernel& kernel);
Recorder box_recorder(const Kernel& kernel);

// The index of a comparison, which is made where it is new.
std::size_t comparison_index(Recording& recording, Value lhs, Value rhs, bool nonstrict);

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

// Records a method that says whether they are separate: every way that its comparisons may go.
// `separated(load)` is called once for each.
template <class Separated>
Recording recorded_paths(const Permissions& permissions, Separated&& separated) {
  Recording made{Graph(permissions)};
  RecordedNumber::graph = &made.graph;
  Path path;
  std::vector<bool> script;  // what the next comparisons are told
  const std::function<bool(Value, Value, bool)> decide = [&](Value lhs, Value rhs, bool nonstrict) {
    const std::size_t i = comparison_index(made, lhs, rhs, nonstrict);
    const std::size_t step = path.decisions.size();
    const bool holds = step < script.size() && script[step];
    path.decisions.emplace_back(i, holds);
    (holds ? path.holding : path.failing) |= one_bit<ComparisonBits>(i);
    return holds;
  };
  RecordedNumber::decide = &decide;
  do {
    path = {};
    path.separates = separated([&](std::size_t k) { return RecordedNumber(made.graph.input(k)); });
    // The next way differs in the last decision that said no.
    script.clear();
    for (const auto& [i, holds] : path.decisions) script.push_back(holds);
    while (!script.empty() && script.back()) script.pop_back();
    if (!script.empty()) script.back() = true;
    made.paths.push_back(std::move(path));
  } while (!script.empty());
  RecordedNumber::decide = nullptr;
  RecordedNumber::graph = nullptr;
  return made;
}

// Records formulae as kernel/formulae_kernel.h has them: `found` where the kernel claims them.
template <class Test, class F>
void put_recorder(const Kernel& kernel, Recorder& found) {
  using T = RecordedNumber;
  if (kernel.predicate != &Test::description() || kernel.entry != entry_of<Test>() || kernel.formulae != F::name)
    return;
  found = [](const Permissions& permissions) {
    return recorded(
        permissions, Test::description().comparisons.size(), nonstrict_comparisons<F>(),
        [](auto&& load, auto&& sink) { F::template comparisons<T>(Test::template problem<T>(load), sink); });
  };
}

}  // namespace axiscert::permitted
