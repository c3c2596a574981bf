#include "exact/sphere_triangle/oracles/exact_truth.h"

#include "exact/numbers/surd.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Both sides over one denominator; a root on the left as its square. Of a root on the right both sides are taken times
// that root: the order stays, and the right side is none any more. The left side is a length then, and not negative.
void set(ExactSides& sides, std::size_t i, const Surd& lhs, const Surd& rhs) {
  if (!rhs.is_rational() && !rhs.is_undefined() && !lhs.is_undefined()) {
    if (rhs.radicand().is_zero()) return set(sides, i, lhs, Surd());
    const Surd square(rhs.radicand()), root = square_root(square);
    set(sides, i, lhs.is_rational() ? lhs * root : square_root(lhs * lhs * square), rhs * root);
    sides.times_root |= one_bit<ComparisonBits>(i);
    return;
  }
  if (lhs.is_undefined() || rhs.is_undefined()) {
    sides.undefined |= one_bit<ComparisonBits>(i);
    return;
  }
  const bool is_greater = lhs > rhs;
  sides.strict |= bit_if<ComparisonBits>(is_greater, i);
  sides.ties |= bit_if<ComparisonBits>(!is_greater && lhs >= rhs, i);
  sides.rooted |= bit_if<ComparisonBits>(!lhs.is_rational(), i);
  const bool is_common = lhs.denominator() == rhs.denominator();
  const BinaryNumber one = BinaryNumber::one();
  const BinaryNumber lhs_factor = is_common ? one : rhs.denominator(), rhs_factor = is_common ? one : lhs.denominator();
  const BinaryNumber numerator = lhs.numerator() * lhs_factor, denominator = lhs.denominator() * lhs_factor;
  sides.lhs[i] = {lhs.is_rational() ? numerator : numerator * numerator * lhs.radicand(), denominator};
  sides.rhs[i] = {rhs.numerator() * rhs_factor, denominator};
}
void set(ExactSides& sides, std::size_t i, const BinaryNumber& lhs, const BinaryNumber& rhs) { sides.set(i, lhs, rhs); }

template <class T, class Real>
portable::Problem<T> exact_problem(const Query<Real>& q) {
  return problem_as<T>(q, [](Real x) { return T(BinaryNumber(static_cast<double>(x))); });
}

template <class F>
using ExactNumber = std::conditional_t<F::is_ring, BinaryNumber, Surd>;

template <class F, class Real>
ExactSides sides_of_query(const Query<Real>& q) {
  ExactSides sides(comparison_count);
  using T = ExactNumber<F>;
  F::comparisons(exact_problem<T>(q),
                 [&](Comparison which, const T& lhs, const T& rhs) { set(sides, index_of(which), lhs, rhs); });
  return sides;
}

template <class F, class Real>
constexpr auto sides_function() -> ExactSides (*)(const Query<Real>&) {
  if constexpr (requires(portable::Problem<Real> p) { F::separated(p); }) return nullptr;
  else return sides_of_query<F, Real>;
}

}  // namespace

template <class Real>
ExactSides exact_sides(Formulae formulae, const Query<Real>& q) {
  using Function = ExactSides (*)(const Query<Real>&);
  static constexpr EnumArray<Formulae, Function> functions = {
#define AXISCERT_FUNCTION(name, type, kind) sides_function<type, Real>(),
      AXISCERT_FORMULAE(AXISCERT_FUNCTION)
#undef AXISCERT_FUNCTION
  };
  return functions[formulae](q);
}
template ExactSides exact_sides<float>(Formulae, const Query<float>&);
template ExactSides exact_sides<double>(Formulae, const Query<double>&);

ExactSides exact_sides(const portable::CentredProblem<BinaryNumber>& centred) {
  ExactSides sides(comparison_count);
  portable::published_comparisons(centred, BinaryNumber(),
                                  [&](Comparison which, const BinaryNumber& lhs, const BinaryNumber& rhs) {
                                    sides.set(index_of(which), lhs, rhs);
                                  });
  return sides;
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
