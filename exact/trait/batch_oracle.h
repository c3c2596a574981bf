// The truths of a batch of queries: those that are certain without arbitrary precision, at once.
#pragma once

#include <optional>

#include "exact/judge/truth.h"
#include "kernel/query.h"

namespace axiscert {

struct Kernel;

// The signs of the comparisons of formulae on a query: those that hold, with their relations, those with equal sides,
// and those whose sign the bounds of the quickest filter determine.
struct KnownSigns {
  ComparisonBits holds = 0, ties = 0, certain = 0;
};

// Serves one thread. A predicate without filters has AskedOneByOne.
template <class Real>
class BatchOracle {
 public:
  virtual ~BatchOracle() = default;
  // Finds what is certain of each query. The batch has to last as long as known() is called.
  virtual void decide(const QueryBatch<Real>& batch) = 0;
  // The truth of query `i` of the batch decided last. Empty: only its oracles know (Oracles::about).
  virtual std::optional<Truth> known(std::size_t i) const = 0;
  // The signs from which a known truth follows; empty where no filter finds them.
  virtual std::optional<KnownSigns> signs(std::size_t) const { return std::nullopt; }
  // The signs of the formulae that a kernel claims, on a query whose truth is known; empty: only its oracles have them
  // (AskedQuery::chain).
  virtual std::optional<KnownSigns> claimed(std::size_t, const Kernel&) const { return std::nullopt; }
  // Has exact arithmetic and a second opinion repeat a sample of what filters decided, by the query's position in a
  // longer sequence: one in `stride` (0: none but the hardest), and more of the hardest. Throws OracleDisagreement.
  virtual void check(std::size_t /*i*/, std::uint64_t /*position*/, std::uint64_t /*stride*/) const {}
};

template <class Real>
class AskedOneByOne final : public BatchOracle<Real> {
 public:
  void decide(const QueryBatch<Real>&) override {}
  std::optional<Truth> known(std::size_t) const override { return std::nullopt; }
};

}  // namespace axiscert
