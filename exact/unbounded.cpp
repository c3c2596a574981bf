#include "exact/unbounded.h"

#include <cfenv>

#include "exact/unbounded_table.h"

namespace axiscert {

#define AXISCERT_DECLARE(name, type, summary) const UnboundedTable& unbounded_table_##name();
AXISCERT_ARITHMETICS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

namespace {

const UnboundedTable& table_of(Arithmetic arithmetic) {
  static constexpr const UnboundedTable& (*tables[])() = {
#define AXISCERT_TABLE(name, type, summary) unbounded_table_##name,
      AXISCERT_ARITHMETICS(AXISCERT_TABLE)
#undef AXISCERT_TABLE
  };
  return tables[static_cast<std::size_t>(arithmetic)]();
}

}  // namespace

template <class Real>
Outcome unbounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q) {
  const UnboundedTable& table = table_of(arithmetic);
  const FloatingScope scope({table.digits[static_cast<std::size_t>(precision_of<Real>)], table.rounding, {}});
  return table.functions[static_cast<std::size_t>(formulae)](widened(q), strictness);
}
template Outcome unbounded<float>(Formulae, Arithmetic, Strictness, const Query<float>&);
template Outcome unbounded<double>(Formulae, Arithmetic, Strictness, const Query<double>&);

template <class Real>
Rounded rounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q) {
  std::feclearexcept(FE_OVERFLOW | FE_UNDERFLOW);
  const Outcome found = reference(formulae, arithmetic, strictness, q);
  const bool left_range = std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW) != 0;
  if (!left_range && table_of(arithmetic).flags_tell_range) return {found, found};
  return {unbounded(formulae, arithmetic, strictness, q), found};
}
template Rounded rounded<float>(Formulae, Arithmetic, Strictness, const Query<float>&);
template Rounded rounded<double>(Formulae, Arithmetic, Strictness, const Query<double>&);

}  // namespace axiscert
