#include "exact/sphere_triangle/unbounded/at_precision.h"

#include "exact/sphere_triangle/unbounded/unbounded_table.h"

namespace axiscert {
namespace {

Outcome evaluate(Formulae formulae, Strictness strictness, const Query<double>& q, int bits,
                 std::optional<Precision> exponents) {
  static const UnboundedTable& plain = unbounded_table_plain();
  const FloatingScope scope({bits, Rounding::nearest, exponents});
  return plain.functions[formulae](q, strictness);
}

}  // namespace

static_assert(greatest_bits <= FloatingScope::greatest_precision);

template <class Real>
Outcome at_precision(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                     std::optional<Precision> exponents) {
  return evaluate(formulae, strictness, widened(q), bits, exponents);
}
template Outcome at_precision<float>(Formulae, Strictness, const Query<float>&, int, std::optional<Precision>);
template Outcome at_precision<double>(Formulae, Strictness, const Query<double>&, int, std::optional<Precision>);

template <class Real>
BothRanges at_precision_in_both_ranges(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                                       Precision exponents) {
  const Query<double>& wide = widened(q);
  mpfr_clear_flags();
  const Outcome limited = evaluate(formulae, strictness, wide, bits, exponents);
  if (!mpfr_overflow_p() && !mpfr_underflow_p()) return {limited, limited};
  return {evaluate(formulae, strictness, wide, bits, std::nullopt), limited};
}
template BothRanges at_precision_in_both_ranges<float>(Formulae, Strictness, const Query<float>&, int, Precision);
template BothRanges at_precision_in_both_ranges<double>(Formulae, Strictness, const Query<double>&, int, Precision);

}  // namespace axiscert
