#include "exact/sphere_triangle/claims/examine.h"

#include <algorithm>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/measures/limits.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {

template <class Real>
Examination Examiner::examine(const Query<Real>& q) {
  auto& implementation = std::get<std::optional<Implementation<Real>>>(begun_);
  if (!implementation) implementation = kernel_.on<Real>(target_);
  Reply<Real> reply = ask(*implementation, q);
  Examination out = axiscert::examine(q, kernel_, reply.outcome(0));
  if (kernel_.exposes == Exposure::sides && out.answer.verdict != Verdict::unanswered) {
    const Sides<Real> sides = sides_at(reply.answers, 0);
    out.sides.emplace();
    std::copy(sides.lhs.begin(), sides.lhs.end(), out.sides->lhs.begin());
    std::copy(sides.rhs.begin(), sides.rhs.end(), out.sides->rhs.begin());
  }
  out.findings = std::move(reply.findings);
  if (out.answer.verdict == Verdict::unanswered) implementation.reset();
  return out;
}
template Examination Examiner::examine(const Query<float>&);
template Examination Examiner::examine(const Query<double>&);

template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, const Answer& answer) {
  Examination out{exact_truth(q, true), {}, answer, {}, {}, {}, true, {}};
  std::optional<Reference> chain;
  if (out.truth.formula) {
    chain = Claims<Real>(q, *out.truth.formula).chain(kernel);
    out.squared_distance = squared_distance(q);
    out.within_limits = is_within(kernel.limits, q);
  }
  out.judgement = judge(*kernel.test, out.truth, chain, out.answer, kernel.touching);
  if (out.judgement.verdict_flip) out.depth = depth(q, *out.squared_distance);
  return out;
}
template Examination examine<float>(const Query<float>&, const Kernel&, const Answer&);
template Examination examine<double>(const Query<double>&, const Kernel&, const Answer&);

}  // namespace axiscert
