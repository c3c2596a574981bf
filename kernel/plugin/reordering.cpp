#include "kernel/plugin/reordering.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace axiscert::plugin {
namespace {

using Order = std::vector<std::size_t>;

// Queries of a batch that are asked alone, each in a call of its own.
constexpr std::size_t most_alone = 251, most_alone_of_program = 4;
// Other queries that stand beside one in the search for the cause.
constexpr std::size_t most_others = 32, most_others_of_program = 4;
constexpr std::size_t most_copies = 33;  // two vectors of sixteen lanes, and one more

Order reversed(std::size_t size) {
  Order order(size);
  std::iota(order.rbegin(), order.rend(), std::size_t{0});
  return order;
}

Order shifted(std::size_t size) {
  Order order(size);
  for (std::size_t i = 0; i < size; ++i) order[i] = (i + 1) % size;
  return order;
}

// Those on either side of a query come first, since they were beside it.
Order others_of(std::size_t query, std::size_t size, std::size_t most) {
  most = std::min(most, size - 1);
  Order others;
  for (std::size_t step = 1; others.size() < most; ++step) {
    others.push_back((query + size - step) % size);
    if (others.size() < most) others.push_back((query + step) % size);
  }
  return others;
}

}  // namespace

template <class Real>
std::optional<OrderDifference> first_by_order(const Reordering<Real>& batch, const Outputs<Real>& outputs) {
  Outputs<Real> again;
  const auto look = [&](const Order& order, const std::string& where) -> std::optional<OrderDifference> {
    if (auto stop = batch.ask(order, again)) {
      if (stop->query) stop->query = order[std::min(*stop->query, order.size() - 1)];
      return OrderDifference{0, "", std::move(stop), where};
    }
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (const auto difference = difference_at(batch.predicate, outputs, order[i], again, i))
        return OrderDifference{order[i], fmt::format("{} {}", *difference, where), std::nullopt, where};
    }
    return std::nullopt;
  };
  if (auto found = look(reversed(batch.size), "with the batch reversed")) return found;
  if (auto found = look(shifted(batch.size), "with the batch shifted by one")) return found;
  const std::size_t alone = std::min(batch.size, batch.is_program ? most_alone_of_program : most_alone);
  for (std::size_t i = 0; i < alone; ++i) {
    if (auto found = look({i * batch.size / alone}, "asked alone")) return found;
  }
  return std::nullopt;
}

template <class Real>
std::string cause_of_difference(const Reordering<Real>& batch, std::size_t query) {
  Outputs<Real> alone, found;
  // How the answer to query `place` of this batch differs from that to the query alone; a call that stops shows
  // nothing.
  const auto difference_now = [&](const Order& order, std::size_t place) -> std::optional<std::string> {
    if (batch.ask(order, found)) return std::nullopt;
    return difference_at(batch.predicate, alone, 0, found, place);
  };
  // One that comes twice: a counter that goes on does not strike at the same place again.
  const auto difference = [&](const Order& order, std::size_t place) {
    auto differs = difference_now(order, place);
    if (differs && !difference_now(order, place)) differs.reset();
    return differs;
  };
  // Twice, so that the query asked before it is itself.
  for (int i = 0; i < 2; ++i) {
    if (batch.ask(Order{query}, alone)) return "";
  }
  for (int i = 0; i < 3; ++i) {
    if (const auto differs = difference_now({query}, 0))
      return fmt::format(": alone, call after call, it says {}: it keeps state from call to call, or is random",
                         *differs);
  }
  // What may have been left by an earlier call: one of the other queries, or the whole batch, which also may have been
  // left by the batch's first queries.
  const std::string kept = "it keeps state from call to call, as where an axis is cached from the last query";
  for (const std::size_t other : others_of(query, batch.size, batch.is_program ? most_others_of_program : most_alone)) {
    std::optional<std::string> differs;
    for (int i = 0; i < 2 && (i == 0 || differs); ++i) {
      if (batch.ask(Order{query}, found) || batch.ask(Order{other}, found)) break;
      differs = difference_now({query}, 0);
    }
    if (differs) return fmt::format(": alone after itself, then after another query, it says {}: {}", *differs, kept);
  }
  Order whole(batch.size), start(std::min(query + 1, most_others));
  std::iota(whole.begin(), whole.end(), std::size_t{0});
  std::iota(start.begin(), start.end(), query + 1 - start.size());
  Outputs<Real> after_itself;
  const std::size_t last = start.size() - 1;
  for (const Order& order : {whole, reversed(batch.size)}) {
    std::optional<std::string> differs;
    for (int i = 0; i < 2 && (i == 0 || differs); ++i) {
      if (batch.ask(start, found) || batch.ask(start, after_itself) || batch.ask(order, found) ||
          batch.ask(start, found))
        break;
      differs = difference_at(batch.predicate, after_itself, last, found, last);
    }
    if (differs)
      return fmt::format(": the same part of the batch after itself, then after all of it, it says {}: {}", *differs,
                         kept);
  }
  for (std::size_t copies = 2; copies <= most_copies && !batch.is_program; ++copies) {
    const Order order(copies, query);
    if (batch.ask(order, found)) break;
    for (std::size_t place = 0; place < copies; ++place) {
      if (!difference_at(batch.predicate, alone, 0, found, place)) continue;
      if (const auto differs = difference_now(order, place)) {
        return fmt::format(
            ": alone, then as number {} of {} copies of itself, it says {}: its answer depends on the "
            "position, or on the length of the batch",
            place + 1, copies, *differs);
      }
    }
  }
  // Copies of it say what it says alone, so what differs now is due to the other query.
  for (const std::size_t other :
       others_of(query, batch.size, batch.is_program ? most_others_of_program : most_others)) {
    for (const auto& [order, place, where] :
         {std::tuple{Order{other, query}, 1u, "after"}, std::tuple{Order{other, query, query}, 1u, "after"},
          std::tuple{Order{query, other}, 0u, "before"}, std::tuple{Order{query, query, other}, 1u, "before"}}) {
      if (const auto differs = difference(order, place)) {
        return fmt::format(": alone, then {} another query in a batch, it says {}: its answer depends on its neighbour",
                           where, *differs);
      }
    }
  }
  return "";
}

#define AXISCERT_INSTANCES(Real)                                                                         \
  template std::optional<OrderDifference> first_by_order(const Reordering<Real>&, const Outputs<Real>&); \
  template std::string cause_of_difference(const Reordering<Real>&, std::size_t);
AXISCERT_INSTANCES(float)
AXISCERT_INSTANCES(double)
#undef AXISCERT_INSTANCES

}  // namespace axiscert::plugin
