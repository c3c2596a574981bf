// Formulae of a predicate as a template over the number type, and the kernel that evaluates them as they stand: one
// query at a time, every operation rounded once to the input's precision.
//
// A predicate's own type, in its room of kernel/, has
//   static const Predicate& description();
//   static constexpr std::size_t entry;                           optional: of the numbers; else the predicate's first
//   template <class T> struct Problem;                            the query in the number type of the formulae
//   template <class T> static Problem<T> problem(load);           load(k) is column k as a T: the only place that knows
//                                                                 the order of the columns
// and each set of formulae
//   static constexpr std::string_view name;                       as a kernel claims it
//   static constexpr FormulaeKind kind;                           rung or variant (kernel/formulae_list.h)
//   template <class T, class Sink>
//   static void comparisons(const Problem<T>&, Sink& sink);       sink(i, lhs, rhs) for each: comparison i is lhs > rhs
//   static constexpr ComparisonBits nonstrict;                    optional: those that are lhs >= rhs
// Formulae, and a method that has a verdict alone, may give the first of the predicate's measures:
//   static constexpr std::size_t measure_count;
//   template <class Real>
//   static void measure(const Problem<Real>&, Real* out);         measure_count numbers
// A number type has + - *, > and >= alone, magnitude(x), and T(x) of a double x, so that each is exact in exact
// arithmetic.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "kernel/formulae_list.h"
#include "kernel/kernel.h"

namespace axiscert {

// The index of the entry in which `Predicate` takes the numbers.
template <class Test>
constexpr std::size_t entry_of() {
  if constexpr (requires { Test::entry; }) return Test::entry;
  else return 0;
}

// The formulae of a predicate. The first are those of the theorem that ties them to the geometry.
template <class... F>
struct FormulaeList {};

// Those of the formulae's comparisons that are `>=`.
template <class F>
constexpr ComparisonBits nonstrict_comparisons() {
  if constexpr (requires { F::nonstrict; }) return F::nonstrict;
  else return 0;
}

// The comparisons of formulae F that hold on one query. `see(i, lhs, rhs)` is shown both sides of each.
template <class F, class T, class Problem, class See>
constexpr ComparisonBits bits_of(const Problem& problem, See&& see) {
  ComparisonBits bits = 0;
  const auto sink = [&](std::size_t i, const T& lhs, const T& rhs) {
    const bool holds = has_bit(nonstrict_comparisons<F>(), i) ? lhs >= rhs : lhs > rhs;
    if (holds) bits |= one_bit<ComparisonBits>(i);
    see(i, lhs, rhs);
  };
  F::template comparisons<T>(problem, sink);
  return bits;
}

template <class M>
concept GivesMeasures = requires { M::measure_count; };

// Formulae or a method M with the measures that it gives; empty where it gives none.
template <class Test, class M, class Real>
std::function<void(const QueryColumns<Real>&, Answers<Real>&)> method_measures() {
  if constexpr (!GivesMeasures<M>) {
    return {};
  } else {
    return [](const QueryColumns<Real>& batch, Answers<Real>& out) {
      for (std::size_t i = 0; i < batch.size; ++i) {
        std::array<Real, M::measure_count> found;
        M::template measure<Real>(Test::template problem<Real>([&](std::size_t k) { return batch.column[k][i]; }),
                                  found.data());
        for (std::size_t k = 0; k < found.size(); ++k) out.measures[k][i] = found[k];
      }
    };
  }
}

template <class Test, class F, class Real>
Implementation<Real> formulae_implementation() {
  const auto bits_at = [](const QueryColumns<Real>& batch, std::size_t i, auto&& see) {
    return bits_of<F, Real>(Test::template problem<Real>([&](std::size_t k) { return batch.column[k][i]; }), see);
  };
  Implementation<Real> made;
  made.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    const Predicate& predicate = Test::description();
    for (std::size_t i = 0; i < batch.size; ++i) {
      out[i] = verdict_of(predicate, bits_at(batch, i, [](std::size_t, Real, Real) {}));
    }
  };
  made.explain = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      out.bits[i] = bits_at(batch, i, [&](std::size_t k, Real lhs, Real rhs) {
        out.lhs[k][i] = lhs;
        out.rhs[k][i] = rhs;
      });
    }
  };
  made.measure = method_measures<Test, F, Real>();
  return made;
}

// The members that all such kernels have; such a kernel is judged by its verdicts, and by the measures that M gives.
template <class Test, class M>
Kernel bare_kernel(std::string id, std::string summary) {
  Kernel kernel;
  kernel.id = std::move(id);
  kernel.summary = std::move(summary);
  kernel.predicate = &Test::description();
  kernel.entry = entry_of<Test>();
  if constexpr (GivesMeasures<M>) kernel.measure_count = M::measure_count;
  return kernel;
}

// The kernel claims these formulae and the bits of the reference, which is itself.
template <class Test, class F>
Kernel formulae_kernel(std::string id, std::string summary) {
  Kernel kernel = bare_kernel<Test, F>(std::move(id), std::move(summary));
  kernel.formulae = F::name;
  kernel.binary32 = [](std::string_view) { return formulae_implementation<Test, F, float>(); };
  kernel.binary64 = [](std::string_view) { return formulae_implementation<Test, F, double>(); };
  return kernel;
}

// A method M that has no comparisons: static bool separated(const Problem<Real>&). It claims nothing.
template <class Test, class M, class Real>
Implementation<Real> method_implementation() {
  Implementation<Real> made;
  made.verdicts = [](const QueryColumns<Real>& batch, Verdict* out) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      const auto q = Test::template problem<Real>([&](std::size_t k) { return batch.column[k][i]; });
      out[i] = M::template separated<Real>(q) ? Verdict::separated : Verdict::contact;
    }
  };
  made.measure = method_measures<Test, M, Real>();
  return made;
}
template <class Test, class M>
Kernel method_kernel(std::string id, std::string summary) {
  Kernel kernel = bare_kernel<Test, M>(std::move(id), std::move(summary));
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  kernel.binary32 = [](std::string_view) { return method_implementation<Test, M, float>(); };
  kernel.binary64 = [](std::string_view) { return method_implementation<Test, M, double>(); };
  return kernel;
}

}  // namespace axiscert
