#include "proofs/certified/graph.h"

#include <bit>
#include <cmath>
#include <stdexcept>

namespace axiscert::proofs::certified {
namespace {

bool is_constant(const Node& node) { return node.op == Op::constant; }

}  // namespace

Index Graph::found_or_made(const Key& key, Node node) {
  const auto [at, is_new] = made_.try_emplace(key, static_cast<Index>(nodes_.size()));
  if (is_new) nodes_.push_back(std::move(node));
  return at->second;
}

Index Graph::input(std::string name) {
  nodes_.push_back({.op = Op::input, .name = std::move(name)});
  return static_cast<Index>(nodes_.size() - 1);
}
Index Graph::number(double x) {
  return found_or_made({Op::constant, {}, std::bit_cast<std::uint64_t>(x)}, {.op = Op::constant, .number = x});
}
Index Graph::word(std::uint64_t x) {
  return found_or_made({Op::word_constant, {}, x}, {.op = Op::word_constant, .word = x});
}
Index Graph::flag(bool x) {
  return found_or_made({Op::flag_constant, {}, std::uint64_t{x}}, {.op = Op::flag_constant, .word = std::uint64_t{x}});
}

Index Graph::node(Op op, std::array<Index, 3> operands) {
  const auto known = [&](std::size_t k) { return nodes_[operands[k]].op == Op::flag_constant; };
  const auto value = [&](std::size_t k) { return nodes_[operands[k]].word != 0; };
  if (op == Op::both || op == Op::either) {
    const bool neutral = op == Op::both;
    for (std::size_t k = 0; k < 2; ++k) {
      if (known(k)) return value(k) == neutral ? operands[1 - k] : operands[k];
    }
  }
  if (op == Op::opposite && known(0)) return flag(!value(0));
  if (op == Op::equal && is_constant(nodes_[operands[0]]) && is_constant(nodes_[operands[1]])) {
    return flag(nodes_[operands[0]].number == nodes_[operands[1]].number);
  }
  // A number read as a word and back, or a word as a number.
  const Node& first = nodes_[operands[0]];
  if ((op == Op::bits && first.op == Op::from_bits) || (op == Op::from_bits && first.op == Op::bits)) {
    return first.operands[0];
  }
  return found_or_made({op, operands, 0}, {.op = op, .operands = operands});
}

std::vector<Index> Graph::needed_by(const std::vector<Index>& results) const {
  std::vector<bool> needed(nodes_.size());
  for (const Index result : results) needed[result] = true;
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    if (!needed[i]) continue;
    for (std::size_t k = 0; k < info(nodes_[i].op).operands; ++k) needed[nodes_[i].operands[k]] = true;
  }
  std::vector<Index> order;
  for (Index i = 0; i < nodes_.size(); ++i) {
    if (needed[i]) order.push_back(i);
  }
  return order;
}

Index RecordedStep::result(std::string_view of) const {
  for (const Result& result : results) {
    if (result.name == of) return result.node;
  }
  throw std::out_of_range("the recorded step " + name + " has no result " + std::string(of));
}

template <>
float as_number<float>(Index node) {
  return std::bit_cast<float>(0x7fc00000u | node);
}
template <>
double as_number<double>(Index node) {
  return std::bit_cast<double>(0x7ff8000000000000ull | node);
}

template <class Real>
Index node_of(Real x) {
  if (!std::isnan(x)) return recorder->number(static_cast<double>(x));
  if constexpr (sizeof(Real) == 4) return std::bit_cast<std::uint32_t>(x) & 0x3fffffu;
  else return static_cast<Index>(std::bit_cast<std::uint64_t>(x));
}
template Index node_of<float>(float x);
template Index node_of<double>(double x);

}  // namespace axiscert::proofs::certified
