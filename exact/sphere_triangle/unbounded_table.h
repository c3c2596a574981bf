// The unbounded evaluation of every set of formulae in one arithmetic.
#pragma once

#include "exact/numbers/floating.h"
#include "exact/numbers/mpfr_number.h"
#include "exact/sphere_triangle/unbounded.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {

using UnboundedFunction = Outcome (*)(const Query<double>&, Strictness);  // a float widens exactly

// `digits` are the precision of the arithmetic's operations on queries in binary32 and in binary64.
struct UnboundedTable {
  EnumArray<Precision, int> digits;
  Rounding rounding;
  bool flags_tell_range;
  EnumArray<Formulae, UnboundedFunction> functions{};  // null where the arithmetic does not exist
};

template <class A>
struct UnboundedNumber {
  using Base = Floating;
  using Type = typename A::template Unbounded<Floating>;
};
template <>
struct UnboundedNumber<arithmetic::WorldDouble> {
  using Base = Mpfr<53>;
  using Type = arithmetic::LargeWorld<Mpfr<53>, Mpfr<24>>;
};

// Scaling by a power of two rounds nothing, but the translation before it does; after it every form is centred.
template <class F, class Number, bool translated_first>
Outcome unbounded_outcome(const Query<double>& q, Strictness strictness) {
  using T = typename Number::Type;
  auto problem = problem_as<T>(q, [](double x) { return T(typename Number::Base(x)); });
  if constexpr (translated_first) {
    const auto& [a, b, c, p, r, zero] = problem;
    problem = {a - p, b - p, c - p, {zero, zero, zero}, r, zero};
  }
  return outcome_of<F>(problem, strictness);
}

// Arithmetics that differ from plain only by a mode share the plain functions.
const UnboundedTable& unbounded_table_plain();

template <Arithmetic arithmetic>
UnboundedTable unbounded_table() {
  using A = ArithmeticType<arithmetic>;
  UnboundedTable table{{std::numeric_limits<typename A::template BaseOf<float>>::digits,
                        std::numeric_limits<typename A::template BaseOf<double>>::digits},
                       A::unbounded_rounding,
                       A::flags_tell_range};
  constexpr bool plain_but_for_a_mode = std::is_same_v<typename UnboundedNumber<A>::Type, Floating> && !A::prescaled;
  if constexpr (arithmetic != Arithmetic::plain && plain_but_for_a_mode) {
    table.functions = unbounded_table_plain().functions;
  } else {
    const auto fill = [&]<std::size_t i>() {
      constexpr auto formulae = static_cast<Formulae>(i);
      if constexpr (arithmetic == Arithmetic::plain || kind_of(formulae) == FormulaeKind::rung) {
        table.functions[i] = unbounded_outcome<FormulaeType<formulae>, UnboundedNumber<A>, A::prescaled>;
      }
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
      (fill.template operator()<i>(), ...);
    }(std::make_index_sequence<formulae_count>());
  }
  return table;
}

}  // namespace axiscert
