// Whether a kernel's answer depends on what else it is asked: batches are asked again in another order, and their
// queries alone; and what a difference is due to, in words.
#pragma once

#include <functional>

#include "kernel/plugin/caller.h"

namespace axiscert::plugin {

// A batch, and how its queries are asked again: by their numbers, in this order, as one call.
template <class Real>
struct Reordering {
  const Predicate& predicate;
  std::size_t size;
  bool is_program;  // each call may be a start, and it knows no lanes
  std::function<std::optional<Stop>(std::span<const std::size_t> order, Outputs<Real>& outputs)> ask;
};

struct OrderDifference {
  std::size_t query;         // 0 with a stop
  std::string detail;        // "verdict contact, then separated with the batch reversed"
  std::optional<Stop> stop;  // then there is no detail, and `where` says how it was asked
  std::string where;
};

// The first answer that differs from `outputs` with the batch reversed, shifted by one, or to a query alone.
template <class Real>
std::optional<OrderDifference> first_by_order(const Reordering<Real>& batch, const Outputs<Real>& outputs);

// Why a query is answered in two ways. It is asked alone, after another, beside another and among copies of itself; the
// first of these that changes its answer is the cause. Begins with a colon; empty where none does.
template <class Real>
std::string cause_of_difference(const Reordering<Real>& batch, std::size_t query);

}  // namespace axiscert::plugin
