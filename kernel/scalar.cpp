#include "kernel/scalar.h"

namespace axiscert {
namespace {

template <class Real>
AXISCERT_INLINE portable::Centred<Real> load(const QueryColumns<Real>& batch, std::size_t i) {
  const auto& k = batch.column;
  return portable::centred<Real>({k[0][i], k[1][i], k[2][i]}, {k[3][i], k[4][i], k[5][i]}, {k[6][i], k[7][i], k[8][i]},
                                 {k[9][i], k[10][i], k[11][i]}, k[12][i]);
}

template <Strictness strictness>
struct Relation {
  template <class Real>
  AXISCERT_INLINE static bool holds(Comparison which, Real lhs, Real rhs) {
    return strictness == Strictness::strict || info(which).is_radius ? lhs > rhs : lhs >= rhs;
  }
};

template <class Real, Strictness strictness>
void verdicts(const QueryColumns<Real>& batch, Verdict* out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    // Bitwise, as the article has it: a branch per comparison would cost more than it saves.
    std::array<bool, axis_count> separates;
    separates.fill(true);
    portable::published_comparisons(load(batch, i), Real(0), [&](Comparison which, Real lhs, Real rhs) {
      separates[static_cast<std::size_t>(info(which).axis)] &= Relation<strictness>::holds(which, lhs, rhs);
    });
    bool any = false;
    for (const bool axis : separates) any |= axis;
    out[i] = static_cast<Verdict>(any);
  }
}

template <class Real, Strictness strictness>
void explain(const QueryColumns<Real>& batch, Answers<Real>& out) {
  for (std::size_t i = 0; i < batch.size; ++i) {
    ComparisonBits bits = 0;
    portable::published_comparisons(load(batch, i), Real(0), [&](Comparison which, Real lhs, Real rhs) {
      const auto k = static_cast<std::size_t>(which);
      bits |= static_cast<ComparisonBits>(Relation<strictness>::holds(which, lhs, rhs) << k);
      out.lhs[k][i] = lhs;
      out.rhs[k][i] = rhs;
    });
    out.bits[i] = bits;
  }
}

}  // namespace

Sides<float> reference_sides(const Query<float>& q) noexcept {
  return published_sides<float>(q, [](float x) { return x; });
}
Sides<double> reference_sides(const Query<double>& q) noexcept {
  return published_sides<double>(q, [](double x) { return x; });
}

template <class Real>
Implementation<Real> scalar_implementation(Strictness strictness) {
  return strictness == Strictness::strict
             ? Implementation<Real>{verdicts<Real, Strictness::strict>, explain<Real, Strictness::strict>}
             : Implementation<Real>{verdicts<Real, Strictness::nonstrict>, explain<Real, Strictness::nonstrict>};
}
template Implementation<float> scalar_implementation<float>(Strictness);
template Implementation<double> scalar_implementation<double>(Strictness);

}  // namespace axiscert
