#include "exact/trait/examine.h"

#include "kernel/ask.h"

namespace axiscert {

template <class Real>
OracleExamination OracleExaminer::examine(const Numbers<Real>& q) {
  auto& implementation = std::get<std::optional<Implementation<Real>>>(begun_);
  if (!implementation) implementation = kernel_.on<Real>(target_);
  Reply<Real> reply = ask(*implementation, q);
  OracleExamination out = examine_by_oracles(q, kernel_, reply.outcome(0), reply.measures(0));
  out.findings = std::move(reply.findings);
  if (out.answer.verdict == Verdict::unanswered) implementation.reset();
  return out;
}
template OracleExamination OracleExaminer::examine(const Numbers<float>&);
template OracleExamination OracleExaminer::examine(const Numbers<double>&);

template <class Real>
OracleExamination examine_by_oracles(const Numbers<Real>& q, const Kernel& kernel, const Answer& answer,
                                     std::vector<double> measures) {
  const Oracles& oracles = oracles_of(kernel);
  OracleExamination out;
  const std::unique_ptr<AskedQuery> asked = oracles.about(q);
  out.truth = asked->truth();
  out.answer = answer;
  out.measures = std::move(measures);
  if (out.truth.verdict != Verdict::invalid) out.is_promised = is_promised(kernel, q);
  std::optional<Reference> chain;
  if (out.truth.verdict != Verdict::invalid) {
    out.claim = asked->claimed(kernel);
    if (out.claim) chain = out.claim->chain;
  }
  out.judgement = judge(*kernel.test, out.truth, chain, answer, kernel.touching);
  if (out.judgement.verdict_flip) out.depth = oracles.depth(q);
  if (!kernel.test->measures.empty() && right_verdict(out.truth, kernel.touching) == Verdict::contact) {
    const auto motion = oracles.motion_judge(q);
    if (answer.verdict == Verdict::contact) out.motion = motion->hit(out.measures);
    if (answer.verdict == Verdict::separated) out.missed = motion->missed();
  }
  return out;
}
template OracleExamination examine_by_oracles(const Numbers<float>&, const Kernel&, const Answer&, std::vector<double>);
template OracleExamination examine_by_oracles(const Numbers<double>&, const Kernel&, const Answer&,
                                              std::vector<double>);

}  // namespace axiscert
