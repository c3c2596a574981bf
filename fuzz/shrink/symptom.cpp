#include "fuzz/shrink/symptom.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "exact/judge/side_error.h"

namespace axiscert {
namespace {

// An axis separates if all of its comparisons hold: the least margin decides. Empty where the oracles tell none.
std::optional<Severity> margin_severity(const std::vector<Rational>& margins) {
  if (margins.empty()) return std::nullopt;
  const Rational& least = *std::min_element(margins.begin(), margins.end());
  return Severity{Rational(abs(least)), fmt::format("relative margin {:.6g}", std::abs(least.get_d()))};
}

// The error of a comparison; empty where it is not finite, and where the kernel shows or claims no sides.
template <class Real>
std::optional<Severity> error_severity(const Kernel& kernel, AskedQuery& about, const Answers<Real>& answers,
                                       std::size_t comparison) {
  if (kernel.exposes != Exposure::sides) return std::nullopt;
  const ExactSides* own = about.sides(kernel);
  if (own == nullptr) return std::nullopt;
  const ExactComparison exact = own->comparison(comparison);
  const SideError error(answers.lhs[comparison][0], answers.rhs[comparison][0], exact);
  if (error.kind() != SideError::Kind::finite) return std::nullopt;
  const Decimal6 rounded_up = error.rounded_up();
  const std::string shown = rounded_up.text() + " u";
  if (exact.is_rooted) return Severity{rounded_up, shown};
  const Fraction fraction = error.exact();
  return Severity{Rational(Rational(fraction.numerator) / Rational(fraction.denominator)), shown};
}

// Whether the kernel's answer permits the symptom: cheap to check before anything exact is computed.
bool can_show(const Symptom& symptom, const Answer& answer) {
  if (answer.verdict == Verdict::unanswered) return false;
  if (symptom.level == Level::verdict) {
    return answer.verdict == (symptom.kind == FlipKind::false_separation ? Verdict::separated : Verdict::contact);
  }
  if (!answer.bits) return false;
  const std::uint64_t bits = symptom.level == Level::axis ? clauses_of(*symptom.predicate, *answer.bits) : *answer.bits;
  return !symptom.kind || has_bit(bits, symptom.index) == (symptom.kind == FlipKind::false_separation);
}

ComparisonBits causes_of(const Predicate& predicate, const Judgement& judgement, const Flip& flip) {
  switch (flip.level) {
    case Level::verdict:
      return judgement.comparison_decisive;
    case Level::axis:
      return judgement.comparison_flips & predicate.clauses[flip.index].comparisons;
    case Level::comparison:
      return one_bit<ComparisonBits>(flip.index);
  }
  return 0;
}

Symptom symptom_of(const Predicate& predicate, const Judgement& judgement, const Flip& flip) {
  return {
      &predicate, flip.level, flip.index, flip.kind, flip.decisive, flip.links, causes_of(predicate, judgement, flip)};
}

bool shows(const Judgement& judgement, const Symptom& symptom) {
  bool found = false;
  judgement.for_each_flip([&](const Flip& flip) {
    const Symptom s = symptom_of(*symptom.predicate, judgement, flip);
    const bool same_causes = (s.causes & ~symptom.causes) == 0 && (s.causes != 0) == (symptom.causes != 0);
    found = found || (s.level == symptom.level && s.index == symptom.index && s.kind == symptom.kind &&
                      s.links == symptom.links && s.decisive >= symptom.decisive && same_causes);
  });
  return found;
}

}  // namespace

std::string_view name(const Symptom& s) {
  return s.measure ? name(measure_of(*s.measure)) : name(*s.predicate, Flip{s.level, s.index, FlipKind{}, false, {}});
}

std::string text(const Symptom& s) {
  if (s.measure) return std::string(name(*s.measure));
  if (!s.kind) return fmt::format("{} error", name(s));
  std::vector<std::string_view> causes;
  for (std::size_t i = 0; i < s.predicate->comparisons.size() && s.level != Level::comparison; ++i) {
    if (has_bit(s.causes, i)) causes.push_back(s.predicate->comparisons[i].name);
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

Severity depth_severity(AskedQuery& asked) {
  if (const std::optional<ExactDepth> exact = asked.exact_depth())
    return {*exact, fmt::format("{:.6g} of the scene", rounded_depth(*exact))};
  return {RoundedDepth{0}, "no depth: the predicate has none"};
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
  return examine(q, kernel_, asked(q).outcome(0)).judgement;
}

template <class Real>
std::vector<Symptom> SymptomFinder<Real>::flips(const Numbers<Real>& q) {
  std::vector<Symptom> all;
  const Judgement found = judgement(q);
  found.for_each_flip([&](const Flip& flip) { all.push_back(symptom_of(*kernel_.predicate, found, flip)); });
  return all;
}

template <class Real>
std::optional<ContactJudgement> SymptomFinder<Real>::contact(const Numbers<Real>& q) {
  if (kernel_.measure_count == 0) return std::nullopt;
  const Reply<Real> reply = asked(q);
  return examine(q, kernel_, reply.outcome(0), reply.measures(0)).contact;
}

template <class Real>
std::vector<Symptom> SymptomFinder<Real>::measure_faults(const Numbers<Real>& q) {
  std::vector<Symptom> all;
  const std::optional<ContactJudgement> found = contact(q);
  for (const MeasureFault which : enumerators<MeasureFault>) {
    if (found && measure_error(*found, which)) all.push_back({.predicate = kernel_.predicate, .measure = which});
  }
  return all;
}

template <class Real>
bool SymptomFinder<Real>::is_compared(const Numbers<Real>& q, MeasureFault which) {
  const std::optional<ContactJudgement> found = contact(q);
  return found && is_judged(*found, which);
}

template <class Real>
std::optional<Symptom> SymptomFinder<Real>::largest_error(const Numbers<Real>& q) {
  if (kernel_.exposes != Exposure::sides) return std::nullopt;
  const auto size_of_error = [](const Severity& severity) {
    if (const auto* exact = std::get_if<Rational>(&severity.exact)) return exact->get_d();
    return std::get<Decimal6>(severity.exact).value();
  };
  std::optional<Symptom> largest;
  double most = 0;
  for (std::uint8_t i = 0; i < kernel_.predicate->comparisons.size(); ++i) {
    const Symptom one{.predicate = kernel_.predicate, .level = Level::comparison, .index = i};
    const std::optional<Severity> found = severity(q, one);
    if (!found || size_of_error(*found) <= most) continue;
    most = size_of_error(*found);
    largest = one;
  }
  return largest;
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
  const Oracles& oracles = oracles_of(kernel_);
  if (!oracles.is_valid(q) || !is_promised(kernel_, q)) return std::nullopt;
  if (symptom.measure) {
    const std::optional<ContactJudgement> found = contact(q);
    auto error = found ? measure_error(*found, *symptom.measure) : std::nullopt;
    return error ? std::optional(Severity{RoundedDepth{error->size}, std::move(error->text)}) : std::nullopt;
  }
  const Reply<Real> reply = asked(q);
  const Answer answer = reply.outcome(0);
  if (!can_show(symptom, answer)) return std::nullopt;
  const std::unique_ptr<AskedQuery> about = oracles.about(q, Opinion::first);
  const Truth truth = about->truth();
  if (truth.verdict == Verdict::invalid) return std::nullopt;
  if (!symptom.kind) return error_severity(kernel_, *about, reply.answers, symptom.index);
  if (!shows(judge(*kernel_.predicate, truth, about->chain(kernel_), answer, kernel_.touching), symptom))
    return std::nullopt;
  switch (symptom.level) {
    case Level::verdict:
      return depth_severity(*about);
    case Level::axis:
      return margin_severity(about->relative_margins(kernel_, symptom.predicate->clauses[symptom.index].comparisons));
    case Level::comparison:
      return margin_severity(about->relative_margins(kernel_, one_bit<ComparisonBits>(symptom.index)));
  }
  return std::nullopt;
}

template class SymptomFinder<float>;
template class SymptomFinder<double>;

template <class Real>
Keep::Keep(const Predicate& predicate, const Numbers<Real>& q, const Severity& severity, std::size_t entry)
    : predicate_(&predicate), entry_(entry), classes_(classes_of(predicate, q, entry)) {
  if (const auto* depth = std::get_if<ExactDepth>(&severity.exact)) {
    // |sqrt(dd) - r| / sqrt(ss) times the factor.
    greatest_ = {
        ExactDepth{Rational(depth->dd * depth_factor * depth_factor), Rational(depth->r * depth_factor), depth->ss},
        ""};
  }
  if (const auto* depth = std::get_if<RoundedDepth>(&severity.exact))
    greatest_ = {RoundedDepth{depth->value * depth_factor}, ""};
}
template Keep::Keep(const Predicate&, const Numbers<float>&, const Severity&, std::size_t);
template Keep::Keep(const Predicate&, const Numbers<double>&, const Severity&, std::size_t);

template <class Real>
bool Keep::allows(const Numbers<Real>& q, const Severity& severity) const {
  if (greatest_ && !is_no_less(*greatest_, severity)) return false;
  if (!classes_) return true;
  const std::vector<std::string_view> meets = classes_of(*predicate_, q, entry_);
  const auto is_kept = [&](std::string_view name) {
    return std::find(classes_->begin(), classes_->end(), name) != classes_->end();
  };
  return meets.front() == classes_->front() && std::all_of(meets.begin(), meets.end(), is_kept);
}
template bool Keep::allows(const Numbers<float>&, const Severity&) const;
template bool Keep::allows(const Numbers<double>&, const Severity&) const;

}  // namespace axiscert
