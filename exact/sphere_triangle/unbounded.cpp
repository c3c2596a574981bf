#include "exact/sphere_triangle/unbounded.h"

#include <algorithm>
#include <cfenv>

#include "exact/sphere_triangle/unbounded_table.h"
#include "exact/sphere_triangle/wide_range_float.h"
#include "kernel/base/arithmetic_list.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {

#define AXISCERT_DECLARE(name, type, summary) const UnboundedTable& unbounded_table_##name();
AXISCERT_ARITHMETICS(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

namespace {

const UnboundedTable& table_of(Arithmetic arithmetic) {
  using Table = const UnboundedTable& (*)();
  static constexpr EnumArray<Arithmetic, Table> tables = {
#define AXISCERT_TABLE(name, type, summary) unbounded_table_##name,
      AXISCERT_ARITHMETICS(AXISCERT_TABLE)
#undef AXISCERT_TABLE
  };
  return tables[arithmetic]();
}

template <class F>
Outcome wide_range_outcome(const Query<double>& q, Strictness strictness) {
  return outcome_of<F>(problem_as<WideRangeFloat>(q, [](double x) { return WideRangeFloat(x); }), strictness);
}

template <Formulae formulae>
constexpr UnboundedFunction wide_range_function() {
  if constexpr (has_comparisons(formulae) && FormulaeType<formulae>::is_ring) {
    return wide_range_outcome<FormulaeType<formulae>>;
  }
  return nullptr;
}

bool within_wide_range(Formulae formulae) {
  const std::optional<ComparisonDegrees> degrees = degrees_of(formulae);
  return degrees && std::all_of(degrees->begin(), degrees->end(), [](const ComparisonDegree& degree) {
           return degree.bits && WideRangeFloat::covers(*degree.bits);
         });
}

// For each set of formulae, R-infinity of binary32 in plain arithmetic on the processor; null if that is not proved
// correct.
UnboundedFunction on_processor(Formulae formulae) {
  static const auto functions = [] {
    EnumArray<Formulae, UnboundedFunction> result = {
#define AXISCERT_FUNCTION(name, type, kind) wide_range_function<Formulae::name>(),
        AXISCERT_FORMULAE(AXISCERT_FUNCTION)
#undef AXISCERT_FUNCTION
    };
    for (const Formulae each : enumerators<Formulae>) {
      if (!within_wide_range(each)) result[each] = nullptr;
    }
    return result;
  }();
  return functions[formulae];
}

}  // namespace

template <class Real>
Outcome unbounded_by_mpfr(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q) {
  const UnboundedTable& table = table_of(arithmetic);
  const FloatingScope scope({table.digits[precision_of<Real>], table.rounding, {}});
  return table.functions[formulae](widened(q), strictness);
}
template Outcome unbounded_by_mpfr<float>(Formulae, Arithmetic, Strictness, const Query<float>&);
template Outcome unbounded_by_mpfr<double>(Formulae, Arithmetic, Strictness, const Query<double>&);

template <class Real>
Outcome unbounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q) {
  const UnboundedTable& table = table_of(arithmetic);
  const int digits = table.digits[precision_of<Real>];
  const UnboundedFunction function = table.functions[formulae];
  const bool plain = function == unbounded_table_plain().functions[formulae];
  if (plain && digits == 24 && table.rounding == Rounding::nearest) {
    if (const UnboundedFunction fast = on_processor(formulae)) return fast(widened(q), strictness);
  }
  return unbounded_by_mpfr(formulae, arithmetic, strictness, q);
}
template Outcome unbounded<float>(Formulae, Arithmetic, Strictness, const Query<float>&);
template Outcome unbounded<double>(Formulae, Arithmetic, Strictness, const Query<double>&);

template <class Real>
RoundedDecisions rounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q) {
  std::feclearexcept(FE_OVERFLOW | FE_UNDERFLOW);
  const Outcome found = reference(formulae, arithmetic, strictness, q);
  const bool left_range = std::fetestexcept(FE_OVERFLOW | FE_UNDERFLOW) != 0;
  if (!left_range && table_of(arithmetic).flags_tell_range) return {found, found};
  return {unbounded(formulae, arithmetic, strictness, q), found};
}
template RoundedDecisions rounded<float>(Formulae, Arithmetic, Strictness, const Query<float>&);
template RoundedDecisions rounded<double>(Formulae, Arithmetic, Strictness, const Query<double>&);

namespace {

Outcome evaluate(Formulae formulae, Strictness strictness, const Query<double>& q, const FloatingFormat& format,
                 Contraction contraction) {
  static const EnumArray<Contraction, const UnboundedTable*> tables = {&unbounded_table_plain(),
                                                                       &unbounded_table_fma()};
  const FloatingScope scope(format);
  return tables[contraction]->functions[formulae](q, strictness);
}

}  // namespace

template <class Real>
Outcome at_precision(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                     std::optional<ExponentLimits> exponents) {
  return evaluate(formulae, strictness, widened(q), {bits, Rounding::nearest, exponents}, Contraction::none);
}
template Outcome at_precision<float>(Formulae, Strictness, const Query<float>&, int, std::optional<ExponentLimits>);
template Outcome at_precision<double>(Formulae, Strictness, const Query<double>&, int, std::optional<ExponentLimits>);

bool has_contraction(Formulae formulae, Contraction contraction) {
  return contraction == Contraction::none || unbounded_table_fma().functions[formulae] != nullptr;
}

template <class Real>
BothRanges in_both_ranges(Formulae formulae, Strictness strictness, const Query<Real>& q, const FloatingFormat& format,
                          Contraction contraction) {
  const Query<double>& wide = widened(q);
  mpfr_clear_flags();
  const Outcome limited = evaluate(formulae, strictness, wide, format, contraction);
  if (!mpfr_overflow_p() && !mpfr_underflow_p()) return {limited, limited};
  FloatingFormat unlimited = format;
  unlimited.exponents.reset();
  return {evaluate(formulae, strictness, wide, unlimited, contraction), limited};
}
template BothRanges in_both_ranges<float>(Formulae, Strictness, const Query<float>&, const FloatingFormat&,
                                          Contraction);
template BothRanges in_both_ranges<double>(Formulae, Strictness, const Query<double>&, const FloatingFormat&,
                                           Contraction);

template <class Real>
std::optional<Query<Real>> rounded_to(const Query<Real>& q, const FloatingFormat& format) {
  const FloatingScope scope({format.precision, Rounding::nearest, format.exponents});
  bool is_there = true;
  const auto rounded = [&](Real x) {
    const Floating nearest = in_format(Floating(x));
    const auto found = static_cast<Real>(mpfr_get_d(nearest.get(), MPFR_RNDN));
    is_there &= mpfr_number_p(nearest.get()) != 0 && mpfr_cmp_d(nearest.get(), found) == 0;
    return found;
  };
  std::array<Real, coordinate_count> numbers = coordinates(q);
  for (Real& x : numbers) x = rounded(x);
  return is_there ? std::optional(from_coordinates(numbers)) : std::nullopt;
}
template std::optional<Query<float>> rounded_to<float>(const Query<float>&, const FloatingFormat&);
template std::optional<Query<double>> rounded_to<double>(const Query<double>&, const FloatingFormat&);

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
