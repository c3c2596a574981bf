#include "exact/examine.h"

#include "exact/depth.h"
#include "exact/geometric_oracle.h"

namespace axiscert {
namespace {

template <class Real>
Answer answer_of(const Query<Real>& q, const Implementation<Real>& kernel) {
  QueryBatch<Real> one(1);
  one.push_back(q);
  Answer answer{Verdict::invalid, std::nullopt};
  kernel.verdicts(one.columns(), &answer.verdict);
  if (kernel.explain) {
    Answers<Real> answers;
    answers.resize(1);
    kernel.explain(one.columns(), answers);
    answer.bits = answers.bits[0];
  }
  return answer;
}

}  // namespace

template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, std::string_view target) {
  return examine(q, kernel, answer_of(q, kernel.on<Real>(target)));
}
template Examination examine<float>(const Query<float>&, const Kernel&, std::string_view);
template Examination examine<double>(const Query<double>&, const Kernel&, std::string_view);

template <class Real>
Examination examine(const Query<Real>& q, const Kernel& kernel, const Answer& answer) {
  Examination out{exact_truth(q, true), {}, answer, {}, {}};
  std::optional<Reference> chain;
  if (out.truth.formula) {
    chain = Claims<Real>(q, *out.truth.formula).chain(kernel);
    out.squared_distance = squared_distance(q);
  }
  out.judgement = judge(out.truth, chain, out.answer);
  if (out.judgement.verdict_flip) out.depth = depth(q, *out.squared_distance);
  return out;
}
template Examination examine<float>(const Query<float>&, const Kernel&, const Answer&);
template Examination examine<double>(const Query<double>&, const Kernel&, const Answer&);

}  // namespace axiscert
