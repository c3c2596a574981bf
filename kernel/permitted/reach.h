// The least and the greatest value of every node over all permitted evaluations, each use of a node evaluated anew; and
// the evaluation that attains one. A magnitude's least value is taken as 0 where its operand may have either sign.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel/permitted/graph.h"

namespace axiscert::permitted {

// Both ends are attained. Beyond the greatest float a value is indeterminate: from -infinity to infinity.
struct Reach {
  float least, greatest;
  bool operator==(const Reach&) const = default;
};

// Sums and products are monotone, so the ends of a node follow from those of its children: of n children by a dynamic
// program over their subsets, 3^n splits.
class Evaluation {
 public:
  explicit Evaluation(const Graph& graph) : graph_(graph), reach_(graph.nodes().size()) {}

  // Nodes behind barriers have the values of `kept`, in the order of kept_nodes(); empty: any of theirs.
  void evaluate(std::span<const float> inputs, std::span<const float> kept = {});
  Reach of(Value v) const;
  // The nodes behind barriers.
  std::vector<std::uint32_t> kept_nodes() const;
  // An expression whose value is of(v).greatest, or .least, with up() and down() around what is not rounded to nearest.
  std::string text(Value v, bool greatest, std::span<const std::string> input_names) const;

 private:
  friend struct Text;
  // The reach of each subset of a node's children, by its mask.
  void subsets(const Node& node, std::vector<Reach>& of) const;

  const Graph& graph_;
  std::vector<Reach> reach_;
  std::vector<Reach> scratch_;
};

// Rounding as permitted: the ends of what an operation may give, of operands that are floats.
Reach rounded_sum(const Permissions& permissions, float a, float b);
Reach rounded_product(const Permissions& permissions, float a, float b);

}  // namespace axiscert::permitted
