// The scalar form of a kernel over batches, for the lines of the registry.
#pragma once

#include <array>

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {

template <class Real>
AXISCERT_INLINE Query<Real> query_at(const QueryColumns<Real>& batch, std::size_t i) {
  const auto& k = batch.column;
  return {{k[0][i], k[1][i], k[2][i]},
          {k[3][i], k[4][i], k[5][i]},
          {k[6][i], k[7][i], k[8][i]},
          {k[9][i], k[10][i], k[11][i]},
          k[12][i]};
}

// Verdicts by the plain formulae, in a loop that the compiler can optimise as a whole. Benchmarks time this function.
template <Formulae formulae, Strictness strictness, class Real>
void scalar_verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  using F = FormulaeType<formulae>;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Query<Real> q = query_at(batch, i);
    const portable::Problem<Real> problem{q.a, q.b, q.c, q.p, q.r, Real(0)};
    if constexpr (!has_comparisons(formulae)) {
      out[i] = F::separated(problem) ? Verdict::separated : Verdict::contact;
    } else {
      // Bitwise, as in the article: a branch per comparison would cost more than it saves.
      EnumArray<Axis, bool> separates;
      std::fill(separates.begin(), separates.end(), true);
      F::comparisons(problem, [&](Comparison which, Real lhs, Real rhs) {
        separates[info(which).axis] &= holds<strictness>(which, lhs, rhs);
      });
      bool any = false;
      for (const bool axis : separates) any |= axis;
      out[i] = static_cast<Verdict>(any);
    }
  }
}

// Whether the formulae say something beside their verdict.
template <Formulae formulae>
constexpr std::size_t measure_count_of() {
  if constexpr (requires { FormulaeType<formulae>::measure_count; }) return FormulaeType<formulae>::measure_count;
  else return 0;
}
template <Formulae formulae, class Real>
void scalar_measures(const QueryColumns<Real>& batch, Answers<Real>& out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    const Query<Real> q = query_at(batch, i);
    std::array<Real, measure_count_of<formulae>()> found;
    FormulaeType<formulae>::template measure<Real>({q.a, q.b, q.c, q.p, q.r, Real(0)}, found.data());
    for (std::size_t k = 0; k < found.size(); ++k) out.measures[k][i] = found[k];
  }
}

// Bits and sides from the reference, query by query.
template <class Real>
auto explain_by_reference(Formulae formulae, Arithmetic arithmetic, Strictness strictness) {
  return [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      Sides<Real> sides;
      out.bits[i] = *reference(formulae, arithmetic, strictness, query_at(batch, i), &sides).bits;
      for (std::size_t k = 0; k < comparison_count; ++k) {
        out.lhs[k][i] = sides.lhs[k];
        out.rhs[k][i] = sides.rhs[k];
      }
    }
  };
}

template <Formulae formulae, Strictness strictness, class Real>
Implementation<Real> scalar_implementation() {
  Implementation<Real> implementation{scalar_verdicts<formulae, strictness, Real>, nullptr};
  if constexpr (has_comparisons(formulae)) {
    implementation.explain = explain_by_reference<Real>(formulae, Arithmetic::plain, strictness);
  }
  if constexpr (measure_count_of<formulae>() != 0) implementation.measure = scalar_measures<formulae, Real>;
  return implementation;
}

// The scalar form in any arithmetic in which the formulae exist.
template <class Real>
Implementation<Real> reference_implementation(Formulae formulae, Arithmetic arithmetic, Strictness strictness) {
  return {[=](const QueryColumns<Real>& batch, Verdict* out) {
            for (std::size_t i = 0; i < batch.size; ++i) {
              out[i] = reference(formulae, arithmetic, strictness, query_at(batch, i)).verdict;
            }
          },
          explain_by_reference<Real>(formulae, arithmetic, strictness)};
}

}  // namespace axiscert
