// The guide of a search: how much of its aim a query shows, and which queries it is about.
#pragma once

#include <vector>

#include "fuzz/queries/query_shape.h"
#include "fuzz/search/moves/dice.h"
#include "fuzz/search/goal.h"
#include "kernel/kernel.h"

namespace axiscert {

template <class Real>
class Guide {
 public:
  explicit Guide(const QueryShape& shape) : shape_(shape) {}
  virtual ~Guide() = default;
  const QueryShape& shape() const { return shape_; }

  // Writes the score of each query, not negative; 0 if it shows nothing. It may change the queries, as the goals about
  // verdicts do: they solve each query's length. `said`: the kernel's verdict on each query as it is left.
  virtual void evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                        std::vector<Verdict>& said) = 0;
  // Brings a query to where the aim is looked for.
  virtual void settle(Numbers<Real>& q) const = 0;
  // A step that an aim has besides the moves that all have; false where this one was not to be taken.
  virtual bool step(const Aim&, Dice&, Numbers<Real>&) const { return false; }
  // Queries that may show of another comparison what this one shows of one.
  virtual std::vector<Numbers<Real>> images(const Numbers<Real>& q) const { return {q}; }

 private:
  QueryShape shape_;
};

}  // namespace axiscert
