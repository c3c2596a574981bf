// The truths of a batch, and on which of its queries a kernel promises to be right: by filters where the test has them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "exact/judge/judge.h"
#include "exact/trait/oracles.h"
#include "kernel/kernel.h"

namespace axiscert {

template <class Real>
class Truths {
 public:
  // The kernel has to outlive this.
  Truths(const Kernel& kernel, std::string_view target);

  // The right verdict on each query, as the kernel's convention has it; empty where neither is wrong, where the numbers
  // are no query, and where the kernel promises nothing. Good until the next call. Throws OracleDisagreement.
  const std::vector<std::optional<Verdict>>& of(const QueryBatch<Real>& batch);
  // Of a single query, by the oracles.
  std::optional<Verdict> of(const Numbers<Real>& query) const;

 private:
  std::optional<Verdict> right(const Truth& truth, const Numbers<Real>& query) const;

  const Kernel& kernel_;
  const Oracles& oracles_;
  const std::unique_ptr<BatchOracle<Real>> filters_;
  std::vector<std::optional<Verdict>> right_;
};

}  // namespace axiscert
