#include "exact/sphere_triangle/oracles/formula_oracle.h"

#include "kernel/sphere_triangle/reference/formulae_types.h"

namespace axiscert {
namespace {

FormulaTruth with_signs(Sides<Ring>&& sides) {
  FormulaTruth truth{std::move(sides), 0, 0};
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const CGAL::Comparison_result order = CGAL::compare(truth.sides.lhs[i], truth.sides.rhs[i]);
    const auto bit = one_bit<SignBits>(i);
    if (order == CGAL::LARGER) truth.strict |= bit;
    if (order == CGAL::EQUAL) truth.ties |= bit;
  }
  return truth;
}

// Both sides over one denominator; a root, which only a lhs can be, as its square.
FormulaTruth with_signs(const Sides<Surd>& sides) {
  FormulaTruth truth{{}, 0, 0};
  truth.denominators.resize(comparison_count, Ring(1));
  for (std::size_t i = 0; i < comparison_count; ++i) {
    const Surd &lhs = sides.lhs[i], &rhs = sides.rhs[i];
    const auto bit = one_bit<SignBits>(i);
    if (lhs.is_undefined() || rhs.is_undefined()) {
      truth.undefined |= bit;
      continue;
    }
    if (lhs > rhs) truth.strict |= bit;
    else if (lhs >= rhs) truth.ties |= bit;
    const bool same = lhs.denominator() == rhs.denominator();
    const Ring lhs_factor = same ? Ring(1) : rhs.denominator(), rhs_factor = same ? Ring(1) : lhs.denominator();
    truth.denominators[i] = lhs.denominator() * lhs_factor;
    truth.sides.rhs[i] = rhs.numerator() * rhs_factor;
    const Ring numerator = lhs.numerator() * lhs_factor;
    if (!lhs.is_rational()) truth.rooted |= bit;
    truth.sides.lhs[i] = lhs.is_rational() ? numerator : numerator * numerator * lhs.radicand();
  }
  return truth;
}

template <class T, class Real>
portable::Problem<T> exact_problem(const Query<Real>& q) {
  return problem_as<T>(q, [](Real x) { return T(Ring(static_cast<double>(x))); });
}

template <class F>
using ExactNumber = std::conditional_t<F::is_ring, Ring, Surd>;

template <class F, class Real>
FormulaTruth truth_of(const Query<Real>& q) {
  return with_signs(sides_of<F>(exact_problem<ExactNumber<F>>(q)));
}

template <class F, class Real>
constexpr auto truth_function() -> FormulaTruth (*)(const Query<Real>&) {
  if constexpr (requires(portable::Problem<Real> p) { F::separated(p); }) return nullptr;
  else return truth_of<F, Real>;
}

}  // namespace

Rational rational(const Ring& x) {
  Rational q;
  x.export_to_mpq_t(q.get_mpq_t());
  return q;
}

ExactComparison FormulaTruth::comparison(std::size_t i) const {
  static const Ring one(1);
  return {sides.lhs[i], sides.rhs[i], denominators.empty() ? one : denominators[i], has_bit(rooted, i),
          has_bit(undefined, i)};
}

template <class Real>
FormulaTruth formula_truth(Formulae formulae, const Query<Real>& q) {
  using Function = FormulaTruth (*)(const Query<Real>&);
  static constexpr EnumArray<Formulae, Function> functions = {
#define AXISCERT_FUNCTION(name, type, kind) truth_function<type, Real>(),
      AXISCERT_FORMULAE(AXISCERT_FUNCTION)
#undef AXISCERT_FUNCTION
  };
  return functions[formulae](q);
}
template FormulaTruth formula_truth<float>(Formulae, const Query<float>&);
template FormulaTruth formula_truth<double>(Formulae, const Query<double>&);

FormulaTruth formula_truth(const portable::Centred<Ring>& centred) {
  return with_signs(published_sides(centred, Ring(0)));
}

template <class Real>
Verdict exact_verdict(Formulae method, const Query<Real>& q) {
  const auto separated = [&]<class F>() -> bool {
    if constexpr (requires(portable::Problem<Real> p) { F::separated(p); }) {
      return F::separated(exact_problem<ExactNumber<F>>(q));
    } else {
      return false;
    }
  };
  switch (method) {
#define AXISCERT_CASE(name, type, kind) \
  case Formulae::name:                  \
    return separated.template operator()<type>() ? Verdict::separated : Verdict::contact;
    AXISCERT_FORMULAE(AXISCERT_CASE)
#undef AXISCERT_CASE
    case Formulae::none:
      break;
  }
  return Verdict::undecided;
}
template Verdict exact_verdict<float>(Formulae, const Query<float>&);
template Verdict exact_verdict<double>(Formulae, const Query<double>&);

}  // namespace axiscert
