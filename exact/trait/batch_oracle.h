// The truths of a batch of queries: those that are certain without arbitrary precision, at once.
#pragma once

#include <optional>

#include "exact/judge/truth.h"
#include "kernel/query.h"

namespace axiscert {

// Serves one thread. A test without filters has AskedOneByOne.
template <class Real>
class BatchOracle {
 public:
  virtual ~BatchOracle() = default;
  // Finds what is certain of each query. The batch has to last as long as known() is called.
  virtual void decide(const QueryBatch<Real>& batch) = 0;
  // The truth of query `i` of the batch decided last. Empty: only its oracles know (Oracles::about).
  virtual std::optional<Truth> known(std::size_t i) const = 0;
};

template <class Real>
class AskedOneByOne final : public BatchOracle<Real> {
 public:
  void decide(const QueryBatch<Real>&) override {}
  std::optional<Truth> known(std::size_t) const override { return std::nullopt; }
};

}  // namespace axiscert
