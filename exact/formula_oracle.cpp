#include "exact/formula_oracle.h"

namespace axiscert {
namespace {

FormulaTruth with_signs(Sides<Ring>&& sides) {
  FormulaTruth truth{std::move(sides), 0, 0};
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const CGAL::Comparison_result order = CGAL::compare(truth.sides.lhs[i], truth.sides.rhs[i]);
    const auto bit = static_cast<ComparisonBits>(1u << i);
    if (order == CGAL::LARGER) truth.strict |= bit;
    if (order == CGAL::EQUAL) truth.ties |= bit;
  }
  return truth;
}

}  // namespace

Rational rational(const Ring& x) {
  Rational q;
  x.export_to_mpq_t(q.get_mpq_t());
  return q;
}

template <class Real>
FormulaTruth formula_truth(const Query<Real>& q) {
  return with_signs(published_sides<Ring>(q, [](Real x) { return Ring(static_cast<double>(x)); }));
}
template FormulaTruth formula_truth<float>(const Query<float>&);
template FormulaTruth formula_truth<double>(const Query<double>&);

FormulaTruth formula_truth(const portable::Centred<Ring>& centred) {
  return with_signs(published_sides(centred, Ring(0)));
}

}  // namespace axiscert
