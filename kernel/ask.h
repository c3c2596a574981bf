// Everything that a kernel says of a batch, asked in the one way that fits it.
#pragma once

#include <optional>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/outcome.h"

namespace axiscert {

// What a kernel said of a batch. Kept from one batch to the next, it allocates nothing.
template <class Real>
struct Reply {
  std::vector<Verdict> verdicts;
  Answers<Real> answers;
  std::vector<Finding> findings;  // of somebody else's code
  bool has_bits = false;          // the kernel exposes comparisons

  // No bits from a kernel that shows only verdicts, or where there is no answer.
  Outcome outcome(std::size_t i) const {
    Outcome found{verdicts[i], std::nullopt};
    if (has_bits && found.verdict != Verdict::unanswered) found.bits = answers.bits[i];
    return found;
  }
  // Of a kernel that exposes them, where there is an answer.
  Sides<Real> sides(std::size_t i) const {
    Sides<Real> s;
    for (std::size_t k = 0; k < comparison_count; ++k) {
      s.lhs[k] = answers.lhs[k][i];
      s.rhs[k] = answers.rhs[k][i];
    }
    return s;
  }
};

template <class Real>
void ask(const Implementation<Real>& kernel, const QueryColumns<Real>& batch, Reply<Real>& reply) {
  reply.verdicts.assign(batch.size, Verdict::unanswered);
  reply.answers.resize(batch.size);
  reply.findings.clear();
  reply.has_bits = kernel.explain != nullptr;
  if (kernel.supervised) {
    kernel.supervised(batch, reply.verdicts.data(), reply.answers, reply.findings);
    return;
  }
  kernel.verdicts(batch, reply.verdicts.data());
  if (kernel.explain) kernel.explain(batch, reply.answers);
}

// A batch of one.
template <class Real>
Reply<Real> ask(const Implementation<Real>& kernel, const Query<Real>& q) {
  QueryBatch<Real> one(1);
  one.push_back(q);
  Reply<Real> reply;
  ask(kernel, one.columns(), reply);
  return reply;
}

}  // namespace axiscert
