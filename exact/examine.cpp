#include "exact/examine.h"

#include "exact/depth.h"
#include "exact/geometric_oracle.h"
#include "exact/limits.h"
#include "kernel/ask.h"

namespace axiscert {

template <class Real>
Examination Examiner::examine(const Query<Real>& q) {
  auto& implementation = std::get<std::optional<Implementation<Real>>>(begun_);
  if (!implementation) implementation = kernel_.on<Real>(target_);
  Reply<Real> reply = ask(*implementation, q);
  Examination out{exact_truth(q, true), {}, reply.outcome(0), {}, {}, true, std::move(reply.findings)};
  if (out.answer.verdict == Verdict::unanswered) implementation.reset();
  std::optional<Reference> chain;
  if (out.truth.formula) {
    chain = Claims<Real>(q, *out.truth.formula).chain(kernel_);
    out.squared_distance = squared_distance(q);
    out.within_limits = is_within(kernel_.limits, q);
  }
  out.judgement = judge(out.truth, chain, out.answer, kernel_.touching);
  if (out.judgement.verdict_flip) out.depth = depth(q, *out.squared_distance);
  return out;
}
template Examination Examiner::examine(const Query<float>&);
template Examination Examiner::examine(const Query<double>&);

}  // namespace axiscert
