#include "kernel/sphere_triangle/forms/scalar.h"

#include "kernel/sphere_triangle/forms/reference_table.h"

namespace axiscert {

#define AXISCERT_DECLARE(name, type, summary) const ReferenceTable& reference_table_##name();
AXISCERT_ARITHMETICS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

template <class Real>
Outcome reference(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q,
                  Sides<Real>* sides) noexcept {
  using Table = const ReferenceTable& (*)();
  static constexpr EnumArray<Arithmetic, Table> tables = {
#define AXISCERT_TABLE(name, type, summary) reference_table_##name,
      AXISCERT_ARITHMETICS(AXISCERT_TABLE)
#undef AXISCERT_TABLE
  };
  const ReferenceTable& table = tables[arithmetic]();
  if constexpr (sizeof(Real) == 4) return table.binary32[formulae](q, strictness, sides);
  else return table.binary64[formulae](q, strictness, sides);
}
template Outcome reference<float>(Formulae, Arithmetic, Strictness, const Query<float>&, Sides<float>*) noexcept;
template Outcome reference<double>(Formulae, Arithmetic, Strictness, const Query<double>&, Sides<double>*) noexcept;

Sides<float> reference_sides(const Query<float>& q) noexcept {
  return sides_of<portable::PublishedFormulae>(problem_as<float>(q, [](float x) { return x; }));
}
Sides<double> reference_sides(const Query<double>& q) noexcept {
  return sides_of<portable::PublishedFormulae>(problem_as<double>(q, [](double x) { return x; }));
}

}  // namespace axiscert
