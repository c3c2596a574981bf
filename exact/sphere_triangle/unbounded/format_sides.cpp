#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "kernel/arithmetic/arithmetic_list.h"
#include "kernel/sphere_triangle/reference/evaluate.h"
#include "kernel/sphere_triangle/reference/formulae_types.h"

namespace axiscert {
namespace {

double nearest_double(const Floating& x) { return mpfr_get_d(x.get(), MPFR_RNDN); }

using SidesFunction = Sides<double> (*)(const Query<double>&);

template <class F, class T>
Sides<double> sides_in_scope(const Query<double>& q) {
  const Sides<T> found = sides_of<F>(problem_as<T>(q, [](double x) { return T(Floating(x)); }));
  Sides<double> sides;
  for (const Comparison c : enumerators<Comparison>) {
    sides.lhs[c] = nearest_double(static_cast<Floating>(found.lhs[c]));
    sides.rhs[c] = nearest_double(static_cast<Floating>(found.rhs[c]));
  }
  return sides;
}

// Null without comparisons, and where the formulae have no form with the contraction.
template <Formulae formulae>
constexpr EnumArray<Contraction, SidesFunction> sides_functions() {
  using F = FormulaeType<formulae>;
  if constexpr (!has_comparisons(formulae)) return {nullptr, nullptr};
  else if constexpr (kind_of(formulae) != FormulaeKind::rung) return {sides_in_scope<F, Floating>, nullptr};
  else return {sides_in_scope<F, Floating>, sides_in_scope<F, ArithmeticType<Arithmetic::fma>::Unbounded<Floating>>};
}

}  // namespace

template <class Real>
std::optional<Sides<double>> sides_in_format(Formulae formulae, const Query<Real>& q, const FloatingFormat& format,
                                             Contraction contraction) {
  static constexpr EnumArray<Formulae, EnumArray<Contraction, SidesFunction>> functions = {
#define AXISCERT_FUNCTIONS(name, type, kind) sides_functions<Formulae::name>(),
      AXISCERT_FORMULAE(AXISCERT_FUNCTIONS)
#undef AXISCERT_FUNCTIONS
  };
  const SidesFunction function = functions[formulae][contraction];
  if (function == nullptr) return std::nullopt;
  const FloatingScope scope(format);
  return function(widened(q));
}
template std::optional<Sides<double>> sides_in_format<float>(Formulae, const Query<float>&, const FloatingFormat&,
                                                             Contraction);
template std::optional<Sides<double>> sides_in_format<double>(Formulae, const Query<double>&, const FloatingFormat&,
                                                              Contraction);

}  // namespace axiscert
