// The trait of a predicate: what has to be known about it at compile time for its oracles to exist. It derives from the
// predicate's own type of kernel/ (kernel/formulae_kernel.h) and adds geometry; exact/judge/oracles_of.h makes oracles
// of it.
#pragma once

#include <concepts>
#include <optional>
#include <string>

#include "exact/judge/judge.h"
#include "exact/numbers/rational.h"
#include "kernel/formulae_kernel.h"
#include "kernel/kernel.h"
#include "kernel/predicate.h"

namespace axiscert {

struct Distance;    // exact/judge/oracles.h
struct ExactDepth;  // exact/judge/depth.h

// A rational as a number type of the formulae (kernel/formulae_kernel.h). Every result is a number of this type, and
// not an expression of GMP's that refers to its operands.

struct ExactNumber {
  Rational value;

  ExactNumber() = default;
  explicit ExactNumber(double x) : value(x) {}  // finite
  explicit ExactNumber(Rational x) : value(std::move(x)) {}

  const Rational& rational() const { return value; }

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) { return of(a.value + b.value); }
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) { return of(a.value - b.value); }
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) { return of(a.value * b.value); }
  // For formulae that divide in a stated place; b is not 0.
  friend ExactNumber operator/(const ExactNumber& a, const ExactNumber& b) { return of(a.value / b.value); }
  friend ExactNumber magnitude(const ExactNumber& a) { return of(abs(a.value)); }
  friend bool operator>(const ExactNumber& a, const ExactNumber& b) { return a.value > b.value; }
  friend bool operator>=(const ExactNumber& a, const ExactNumber& b) { return a.value >= b.value; }

 private:
  template <class Expression>
  static ExactNumber of(const Expression& x) {
    return ExactNumber(Rational(x));
  }
};

// `numbers` are doubles, to which floats widen exactly, in the order of the columns of the trait's entry; all but
// is_valid() are asked about valid queries alone.
//   AllFormulae        a FormulaeList; those of kind `rung` after the first have its signs on every query, and
//                      those that derive from it its comparisons, with other relations
//   ClearForms         optional: a FormulaeList of those whose bounds make a query clear (exact/judge/clear.h); else
//                      the first formulae
//   Exact              optional: the number type in which the formulae are exact; BinaryFraction where they divide,
//                      else BinaryNumber
//   is_valid           whether the numbers are a query; else the truth is `invalid`
//   why_invalid        optional: the reason, in words, for which they are not a query
//   geometric_truth    by an exact method that shares nothing with the formulae: a Truth, or one with more that
//                      contradiction() is to know
//   contradiction      the theorem that ties the first formulae to the geometry. `holds` and `ties` are their exact
//                      signs, lhs > rhs and lhs == rhs; the result says what the theorem excludes, or is empty
//   exact_depth        optional: how far the query is from touching, relative to its scene
//   squared_critical_length
//                      optional: that of the entry's first length (CriticalLength::squared); numbers are finite
//   critical_centre    optional: CriticalLength::centre
//   is_degenerate<Real>
//                      optional: whether the shape is extreme in this precision (Oracles::is_degenerate); numbers are
//                      finite
//   details<Real>      optional: further facts about a query in this precision, by detail_names(), which a predicate
//   that
//                      has them gives too (exact/judge/oracles.h)
//   distance           optional: what a kernel's margin is held against
//   is_in_front        of a predicate with a front (kernel/predicate.h): whether the centre is in front of the triangle
//   is_promised        of a predicate of motions, optional: whether a kernel with this policy promises to be right on
//                      a query
//   contact_judge<Real> of a predicate with measures that are judged: a judge of those of a valid query; of motions, of
//                      one that has contact
template <class Trait>
concept PredicateTrait = requires(const Numbers<double>& numbers, ComparisonBits holds, ComparisonBits ties) {
  { Trait::description() } -> std::same_as<const Predicate&>;
  typename Trait::template Problem<ExactNumber>;
  typename Trait::AllFormulae;
  { Trait::is_valid(numbers) } -> std::same_as<bool>;
  { Trait::geometric_truth(numbers) } -> std::convertible_to<Truth>;
  { Trait::contradiction(numbers, Trait::geometric_truth(numbers), holds, ties) } -> std::same_as<std::string>;
};

template <class Trait>
concept HasDepth = requires(const Numbers<double>& numbers) {
  { Trait::exact_depth(numbers) } -> std::same_as<ExactDepth>;
};

template <class Trait>
concept HasCriticalLength = requires(const Numbers<double>& numbers) {
  { Trait::squared_critical_length(numbers) } -> std::same_as<std::optional<Rational>>;
};

template <class Trait, class Real>
concept SaysDegenerate = requires(const Numbers<double>& numbers) {
  { Trait::template is_degenerate<Real>(numbers) } -> std::same_as<bool>;
};

template <class Trait>
concept SaysWhyInvalid = requires(const Numbers<double>& numbers) {
  { Trait::why_invalid(numbers) } -> std::same_as<std::string>;
};

template <class Trait, class Real>
concept HasDetails = requires(const Numbers<double>& numbers) { Trait::template details<Real>(numbers); };

template <class Trait>
concept HasMotionPolicy = requires(const MotionPolicy& policy, const Numbers<double>& numbers) {
  { Trait::is_promised(policy, numbers) } -> std::same_as<bool>;
};

template <class Trait>
concept HasFront = requires(const Numbers<double>& numbers) {
  { Trait::is_in_front(numbers) } -> std::same_as<bool>;
};

template <class Trait>
concept HasDistance = requires(const Numbers<double>& numbers) {
  { Trait::distance(numbers) } -> std::same_as<Distance>;
};

template <class Trait, class Real>
concept HasContactJudge = requires(const Numbers<double>& numbers) { Trait::template contact_judge<Real>(numbers); };

}  // namespace axiscert
