#include "exact/judge/examine.h"

#include "kernel/ask.h"

namespace axiscert {
namespace {

template <class Real>
ShownSides sides_in(const Answers<Real>& answers) {
  ShownSides sides;
  for (const std::vector<Real>& column : answers.lhs) sides.lhs.push_back(column[0]);
  for (const std::vector<Real>& column : answers.rhs) sides.rhs.push_back(column[0]);
  return sides;
}

template <class Real>
Examination examination(const Numbers<Real>& q, const Kernel& kernel, const Answer& answer,
                        std::vector<double> measures) {
  const Oracles& oracles = oracles_of(kernel);
  Examination out;
  const std::unique_ptr<AskedQuery> asked = oracles.about(q);
  out.truth = asked->truth();
  out.answer = answer;
  out.measures = std::move(measures);
  std::optional<Reference> chain;
  if (out.truth.verdict != Verdict::invalid) {
    chain = asked->chain(kernel);
    out.exact = asked->published_signs();
    if (!out.exact && chain && chain->exact.bits) out.exact = ExactSigns{*chain->exact.bits, chain->ties};
    out.squared_distance = asked->squared_distance();
    out.is_promised = is_promised(kernel, q);
  }
  out.judgement = judge(*kernel.predicate, out.truth, chain, answer, kernel.touching);
  if (out.judgement.verdict_flip) out.depth = oracles.depth(q);
  if (out.depth) out.length = asked->depth().length();
  if (out.truth.verdict != Verdict::invalid && has_judged_contact(kernel, answer.verdict, [&] { return out.truth; })) {
    if (const auto contact = oracles.contact_judge(q)) {
      contact->declare_margin(kernel.limits.margin);
      out.contact = contact->judge(answer.verdict, out.measures);
    }
  }
  return out;
}

}  // namespace

template <class Real>
Examination Examiner::examine_as(const Numbers<Real>& q) {
  auto& implementation = std::get<std::optional<Implementation<Real>>>(begun_);
  if (!implementation) implementation = kernel_.on<Real>(target_);
  Reply<Real> reply = ask(*implementation, q);
  Examination out = axiscert::examine(q, kernel_, reply.outcome(0), reply.measures(0));
  const bool is_answered = out.answer.verdict != Verdict::unanswered;
  if (kernel_.exposes == Exposure::sides && is_answered && reply.has_bits) out.sides = sides_in(reply.answers);
  out.findings = std::move(reply.watched.findings);
  if (!is_answered) implementation.reset();
  return out;
}
template Examination Examiner::examine_as(const Numbers<float>&);
template Examination Examiner::examine_as(const Numbers<double>&);

Examination examine(const Numbers<float>& q, const Kernel& kernel, const Answer& answer, std::vector<double> measures) {
  return examination(q, kernel, answer, std::move(measures));
}
Examination examine(const Numbers<double>& q, const Kernel& kernel, const Answer& answer,
                    std::vector<double> measures) {
  return examination(q, kernel, answer, std::move(measures));
}

}  // namespace axiscert
