#include "fuzz/shrink/symptom.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "exact/sphere_triangle/measures/error_measure.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "exact/trait/examine.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {
namespace {

// (lhs - rhs) / (|lhs| + |rhs|); 0/0 gives 0.
Rational margin_of(const Rational& lhs, const Rational& rhs) {
  const Rational scale = abs(lhs) + abs(rhs);
  return sgn(scale) == 0 ? Rational(0) : Rational((lhs - rhs) / scale);
}

// The same, or with the signed squares; undefined values give 0.
Rational relative_margin(const ExactComparison& sides) {
  if (sides.undefined) return 0;
  Rational lhs = rational(sides.lhs), rhs = rational(sides.rhs);
  if (sides.rooted) rhs = rhs * abs(rhs);
  return margin_of(lhs, rhs);
}

// An axis separates if all of its comparisons hold: the least margin decides. relative(k) is that of comparison k.
template <class Relative>
Rational axis_margin(const TestDescription& test, std::size_t axis, Relative&& relative) {
  Rational least = 1;
  for_each_bit(test.clauses[axis].comparisons, [&](std::size_t k) { least = std::min(least, Rational(relative(k))); });
  return least;
}

Severity of_margin(const Rational& margin) {
  return {Rational(abs(margin)), fmt::format("relative margin {:.6g}", std::abs(margin.get_d()))};
}

// Whether the kernel's answer permits the symptom: cheap to check before anything exact is computed.
bool can_show(const Symptom& symptom, const Answer& answer) {
  if (answer.verdict == Verdict::unanswered) return false;
  if (symptom.level == Level::verdict) {
    return answer.verdict == (symptom.kind == FlipKind::false_separation ? Verdict::separated : Verdict::contact);
  }
  if (!answer.bits) return false;
  const std::uint64_t bits = symptom.level == Level::axis ? clauses_of(*symptom.test, *answer.bits) : *answer.bits;
  return !symptom.kind || has_bit(bits, symptom.index) == (symptom.kind == FlipKind::false_separation);
}

ComparisonBits causes_of(const TestDescription& test, const Judgement& judgement, const Flip& flip) {
  switch (flip.level) {
    case Level::verdict:
      return judgement.comparison_decisive;
    case Level::axis:
      return judgement.comparison_flips & test.clauses[flip.index].comparisons;
    case Level::comparison:
      return one_bit<ComparisonBits>(flip.index);
  }
  return 0;
}

Symptom symptom_of(const TestDescription& test, const Judgement& judgement, const Flip& flip) {
  return {flip.level, flip.index, flip.kind, flip.decisive, flip.links, causes_of(test, judgement, flip), &test};
}

bool shows(const Judgement& judgement, const Symptom& symptom) {
  bool found = false;
  judgement.for_each_flip([&](const Flip& flip) {
    const Symptom s = symptom_of(*symptom.test, judgement, flip);
    const bool same_causes = (s.causes & ~symptom.causes) == 0 && (s.causes != 0) == (symptom.causes != 0);
    found = found || (s.level == symptom.level && s.index == symptom.index && s.kind == symptom.kind &&
                      s.links == symptom.links && s.decisive >= symptom.decisive && same_causes);
  });
  return found;
}

}  // namespace

std::string_view name(const Symptom& s) { return name(*s.test, Flip{s.level, s.index, FlipKind{}, false, {}}); }

std::string text(const Symptom& s) {
  if (!s.kind) return fmt::format("{} error", name(s));
  std::vector<std::string_view> causes;
  for (std::size_t i = 0; i < s.test->comparisons.size() && s.level != Level::comparison; ++i) {
    if (has_bit(s.causes, i)) causes.push_back(s.test->comparisons[i].name);
  }
  return fmt::format("{} {}{} [{}]{}{}", name(s), flip_kind_names[*s.kind],
                     s.level == Level::verdict ? ""
                     : s.decisive              ? " decisive"
                                               : " masked",
                     fmt::join(names(s.links), " "), causes.empty() ? "" : " by ", fmt::join(causes, ", "));
}

bool is_no_less(const Severity& now, const Severity& then) {
  if (const auto* depth = std::get_if<ExactDepth>(&now.exact))
    return compare(*depth, std::get<ExactDepth>(then.exact)) >= 0;
  // Rounding is monotone: a greater rounded depth is a greater one.
  if (const auto* depth = std::get_if<RoundedDepth>(&now.exact))
    return depth->value >= std::get<RoundedDepth>(then.exact).value;
  if (const auto* margin = std::get_if<Rational>(&now.exact)) return *margin >= std::get<Rational>(then.exact);
  // Rounding up is monotone: the number with the greater rounded value is the greater one.
  return std::get<Decimal6>(now.exact) > std::get<Decimal6>(then.exact);
}

template <class Real>
Reply<Real> SymptomFinder<Real>::asked(const Numbers<Real>& q) {
  if (!implementation_) implementation_ = kernel_.on<Real>(target_);
  Reply<Real> reply = ask(*implementation_, q);
  if (reply.verdicts[0] == Verdict::unanswered) implementation_.reset();
  return reply;
}

template <class Real>
Judgement SymptomFinder<Real>::judgement(const Numbers<Real>& q) {
  const Answer answer = asked(q).outcome(0);
  if (kernel_.test == &first_test()) return examine(query_from(q), kernel_, answer).judgement;
  return examine(q, kernel_, answer).judgement;
}

template <class Real>
std::vector<Symptom> SymptomFinder<Real>::flips(const Numbers<Real>& q) {
  std::vector<Symptom> all;
  const Judgement found = judgement(q);
  found.for_each_flip([&](const Flip& flip) { all.push_back(symptom_of(*kernel_.test, found, flip)); });
  return all;
}

template <class Real>
std::optional<std::string> SymptomFinder<Real>::why_no_verdict(const Numbers<Real>& q) {
  if (!is_promised(kernel_, q)) return "the query is outside the limits that it declares: it promises nothing there";
  switch (asked(q).verdicts[0]) {
    case Verdict::contact:
    case Verdict::separated:
      return std::nullopt;
    case Verdict::undecided:
      return kernel_.may_decline ? "it declines to say (undecided)"
                                 : "it says undecided, and does not declare that it may decline: a fault by itself";
    case Verdict::invalid:
      return "it calls this valid query invalid: a fault by itself";
    case Verdict::unanswered:
      return "it gives no answer: a fault by itself";
  }
  return std::nullopt;
}

template <class Real>
std::optional<Severity> SymptomFinder<Real>::severity(const Numbers<Real>& q, const Symptom& symptom) {
  if (kernel_.test == &first_test()) return severity_of_first_test(query_from(q), symptom);
  return severity_by_oracles(q, symptom);
}

template <class Real>
std::optional<Severity> SymptomFinder<Real>::severity_by_oracles(const Numbers<Real>& q, const Symptom& symptom) {
  const Answer answer = asked(q).outcome(0);
  if (!can_show(symptom, answer) || !symptom.kind) return std::nullopt;
  const Examination found = examine(q, kernel_, answer);
  if (!shows(found.judgement, symptom)) return std::nullopt;
  if (symptom.level == Level::verdict) {
    if (!found.depth) return Severity{RoundedDepth{0}, "no depth: the test has none"};
    return Severity{RoundedDepth{*found.depth}, fmt::format("{:.6g} of the scene", *found.depth)};
  }
  const auto relative = [&](std::size_t k) {
    return margin_of(rational(found.claim->sides->lhs[k]), rational(found.claim->sides->rhs[k]));
  };
  if (!found.claim || !found.claim->sides) return std::nullopt;
  return of_margin(symptom.level == Level::axis ? axis_margin(*symptom.test, symptom.index, relative)
                                                : relative(symptom.index));
}

template <class Real>
std::optional<Severity> SymptomFinder<Real>::severity_of_first_test(const Query<Real>& q, const Symptom& symptom) {
  if (!is_valid(q) || !is_within(kernel_.limits, q)) return std::nullopt;
  const Reply<Real> reply = asked(q);
  const Answer answer = reply.outcome(0);
  if (!can_show(symptom, answer)) return std::nullopt;
  const ExactTruth truth = exact_truth(q, false);
  Claims<Real> claims(q, *truth.formula);
  if (!symptom.kind) {
    const FormulaTruth* own = claims.sides(kernel_.formulae);
    if (own == nullptr || kernel_.exposes != Exposure::sides) return std::nullopt;
    const Sides<Real> sides = sides_at(reply.answers, 0);
    const auto exact = own->comparison(symptom.index);
    const ComparisonError error(sides.lhs[symptom.index], sides.rhs[symptom.index], exact);
    if (error.kind() != ComparisonError::Kind::finite) return std::nullopt;
    const Decimal6 digits = error.rounded_up();
    const std::string shown = digits.text() + " u";
    if (exact.rooted) return Severity{digits, shown};
    const Fraction fraction = error.exact();
    return Severity{Rational(fraction.numerator) / Rational(fraction.denominator), shown};
  }
  const Judgement judgement = judge(first_test(), truth, claims.chain(kernel_), answer, kernel_.touching);
  if (!shows(judgement, symptom)) return std::nullopt;
  switch (symptom.level) {
    case Level::verdict: {
      const Rational distance = squared_distance(q);
      return Severity{exact_depth(q, distance), fmt::format("{:.6g} of the scene", depth(q, distance))};
    }
    case Level::axis:
      return of_margin(axis_margin(*symptom.test, symptom.index, [&](std::size_t k) {
        return relative_margin(claims.sides(kernel_.formulae)->comparison(k));
      }));
    case Level::comparison:
      return of_margin(relative_margin(claims.sides(kernel_.formulae)->comparison(symptom.index)));
  }
  return std::nullopt;
}

template class SymptomFinder<float>;
template class SymptomFinder<double>;

}  // namespace axiscert
