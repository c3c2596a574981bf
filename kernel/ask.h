// Everything that a kernel says about a batch, obtained by the one way of calling that fits the kernel.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "kernel/kernel.h"
#include "kernel/outcome.h"

namespace axiscert {

// The answers of a kernel to a batch. A Reply that is reused for the next batch allocates nothing.
template <class Real>
struct Reply {
  std::vector<Verdict> verdicts;
  Answers<Real> answers;
  Watched watched;        // of a kernel that is not built in
  bool has_bits = false;  // the kernel exposes comparisons

  // The verdict, and the bits unless the kernel shows only verdicts or gave no answer.
  Outcome outcome(std::size_t i) const {
    Outcome found{verdicts[i], std::nullopt};
    if (has_bits && found.verdict != Verdict::unanswered) found.bits = answers.bits[i];
    return found;
  }

  // The measures that the kernel gives, in the order of the predicate's; empty where it gave no answer. Floats widen
  // exactly.
  std::vector<double> measures(std::size_t i) const {
    std::vector<double> found;
    if (verdicts[i] == Verdict::unanswered) return found;
    for (const std::vector<Real>& column : answers.measures) found.push_back(column[i]);
    return found;
  }
};

template <class Real>
void ask(const Implementation<Real>& kernel, const QueryColumns<Real>& batch, Reply<Real>& reply) {
  reply.verdicts.assign(batch.size, Verdict::unanswered);
  reply.answers.resize(batch.size, kernel.comparisons, kernel.measure_count);
  reply.watched = {};
  reply.has_bits = kernel.explain != nullptr;
  if (kernel.supervised) {
    kernel.supervised(batch, reply.verdicts.data(), reply.answers, reply.watched);
    return;
  }
  kernel.verdicts(batch, reply.verdicts.data());
  if (kernel.explain) kernel.explain(batch, reply.answers);
  if (kernel.measure) kernel.measure(batch, reply.answers);
}

// A batch of one.
template <class Real>
Reply<Real> ask(const Implementation<Real>& kernel, const std::type_identity_t<Numbers<Real>>& q) {
  QueryBatch<Real> one(1, q.size());
  one.push_back(q);
  Reply<Real> reply;
  ask(kernel, one.columns(), reply);
  return reply;
}

}  // namespace axiscert
