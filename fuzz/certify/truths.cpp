#include "fuzz/certify/truths.h"

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/trait/oracles.h"

namespace axiscert {

template <class Real>
Truths<Real>::Truths(const Kernel& kernel, std::string_view target)
    : kernel_(kernel), cascade_(filter_on<Real>(target)) {}

template <class Real>
std::optional<Verdict> Truths<Real>::exactly(const Numbers<Real>& query) const {
  const Truth truth =
      kernel_.test == &first_test() ? Truth(exact_truth(query_from(query), false)) : oracles_of(kernel_).truth(query);
  if (truth.verdict == Verdict::invalid || !is_promised(kernel_, query)) return std::nullopt;
  return right_verdict(truth, kernel_.touching);
}

template <class Real>
std::optional<Verdict> Truths<Real>::of(const Numbers<Real>& query) const {
  return exactly(query);
}

template <class Real>
const std::vector<std::optional<Verdict>>& Truths<Real>::of(const QueryBatch<Real>& batch) {
  right_.assign(batch.size(), std::nullopt);
  const std::vector<DecidedSigns>* decided = nullptr;
  if (kernel_.test == &first_test()) decided = &cascade_.decide(batch);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> query = batch[i];
    if (decided == nullptr || (*decided)[i].step == Step::exact) {
      right_[i] = exactly(query);
      continue;
    }
    if (!is_promised(kernel_, query)) continue;
    const Signs& signs = (*decided)[i].signs;
    right_[i] = right_verdict({verdict_of(signs), is_touching(signs, query_from(query).r == 0)}, kernel_.touching);
  }
  return right_;
}

template class Truths<float>;
template class Truths<double>;

}  // namespace axiscert
