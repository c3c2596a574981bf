#include "fuzz/certify/truths.h"

namespace axiscert {

template <class Real>
Truths<Real>::Truths(const Kernel& kernel, std::string_view target)
    : kernel_(kernel), oracles_(oracles_of(kernel)), filters_(batches_of<Real>(oracles_, target)) {}

template <class Real>
std::optional<Verdict> Truths<Real>::right(const Truth& truth, const Numbers<Real>& query) const {
  if (truth.verdict == Verdict::invalid || !is_promised(kernel_, query)) return std::nullopt;
  return right_verdict(truth, kernel_.touching);
}

template <class Real>
std::optional<Verdict> Truths<Real>::of(const Numbers<Real>& query) const {
  return right(oracles_.about(query, Opinion::first)->truth(), query);
}

template <class Real>
const std::vector<std::optional<Verdict>>& Truths<Real>::of(const QueryBatch<Real>& batch) {
  right_.assign(batch.size(), std::nullopt);
  filters_->decide(batch);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> query = batch[i];
    const std::optional<Truth> known = filters_->known(i);
    right_[i] = known ? right(*known, query) : of(query);
  }
  return right_;
}

template class Truths<float>;
template class Truths<double>;

}  // namespace axiscert
