// Whether a verdict is within what is permitted.
#pragma once

#include <span>
#include <vector>

#include "kernel/permitted/graph.h"
#include "kernel/permitted/reach.h"

namespace axiscert::permitted {

// Looks for one verdict among all permitted evaluations of formulae; a thread has its own.
class Adversary {
 public:
  // It gives up, where values are behind barriers, after so many choices that do not lead to the verdict, for each set
  // of comparisons that suffices.
  Adversary(const Predicate& predicate, const Recording& recording, Verdict wished, std::size_t tries = 4096);

  // `wished` where it can be, else the other verdict. The evaluation has the values by which.
  Verdict answer(std::span<const float> query);

  Evaluation& evaluation() { return evaluation_; }
  // The index of the way that the last answer took, through formulae that branch.
  std::size_t path() const { return path_; }
  // Whether a comparison may hold, or fail.
  bool can_be(std::size_t comparison, bool holding);

 private:
  // Comparisons that suffice for the wished verdict; where there are none, the clauses of the predicate say it.
  struct Way {
    ComparisonBits holding = 0, failing = 0;
    std::size_t path = 0;
    std::vector<std::uint32_t> kept;  // the nodes behind barriers on which it depends
  };
  bool is_open(const Way& way);
  bool is_open_with_one_value_each(const Way& way, std::size_t first);
  std::vector<std::uint32_t> kept_below(ComparisonBits comparisons) const;

  const Predicate& predicate_;
  const Recording& recording_;
  Verdict wished_;
  Evaluation evaluation_;
  std::vector<Way> ways_;
  std::size_t path_ = 0, tries_, left_ = 0;  // left_: of the tries
};

}  // namespace axiscert::permitted
