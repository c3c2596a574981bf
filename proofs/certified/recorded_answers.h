// The answers of a recorded step to a query, as the step itself gives them.
#pragma once

#include "proofs/certified/evaluate.h"
#include "proofs/certified/graph.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::proofs::certified {

struct StepAnswers {
  std::uint64_t bits = 0;                   // the flags among the results, in their order
  std::uint64_t known = 0, known_open = 0;  // the bits of Known, of the steps that tell them
  friend bool operator==(const StepAnswers&, const StepAnswers&) = default;
};

// The step has to outlive it.
template <class Real>
class RecordedAnswers {
 public:
  explicit RecordedAnswers(const RecordedStep& step) : evaluated_(step) {
    int bit = 0;
    for (const Result& result : step.results) {
      const Sort sort = info(step.graph.nodes()[result.node].op).sort;
      if (sort == Sort::flag) flags_.push_back({result.node, bit++});
      if (sort == Sort::word) (result.name == "known_open" ? known_open_ : known_) = result.node;
    }
  }
  StepAnswers operator()(const Query<Real>& q) {
    const auto v = coordinates(q);
    evaluated_.compute(std::span<const Real, 13>(v));
    StepAnswers answers;
    for (const auto& [node, bit] : flags_) answers.bits |= std::uint64_t{evaluated_.flag_at(node)} << bit;
    if (known_ != none) answers.known = evaluated_.word_at(known_);
    if (known_open_ != none) answers.known_open = evaluated_.word_at(known_open_);
    return answers;
  }

 private:
  static constexpr Index none = ~Index{0};
  struct Flag {
    Index node;
    int bit;
  };
  EvaluatedStep<Real> evaluated_;
  std::vector<Flag> flags_;
  Index known_ = none, known_open_ = none;
};

}  // namespace axiscert::proofs::certified
