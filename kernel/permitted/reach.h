// The least and the greatest value of every node over all permitted evaluations, each use of a node evaluated anew; and
// the evaluation that attains one. Of a divisor, and of a magnitude's operand, the ends alone are tried: where these
// have both signs a quotient may be greater, and a magnitude less. Behind a barrier the ends alone are tried too. Not
// tried: a product distributed over a sum, or a sum as a common factor that only factoring makes; a comparison as a
// difference, (x / y) * y as x; another grouping of a sum of sums of more than ten terms together.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/permitted/graph.h"
#include "kernel/permitted/permissions.h"

namespace axiscert::permitted {

// An interval that holds all that a node may be, quickly found. A radius of infinity: nothing is known.
struct Outer {
  double middle, radius;
};

// Values of one query, found when they are asked for. Sums and products are monotone, so the ends of a node follow from
// those of its children: of n children by a dynamic program over their subsets, 3^n splits.
class Evaluation {
 public:
  explicit Evaluation(const Graph& graph)
      : graph_(graph), reach_(graph.nodes().size()), outer_(reach_.size()), fixed_(reach_.size()) {}

  void start(std::span<const float> inputs);
  // A node behind a barrier has one value, at every use; nothing: any that it may have.
  void fix(std::uint32_t kept, std::optional<float> value);
  Reach of(Value v);
  // Holds of(v), whatever is fixed.
  Outer outer_of(Value v);
  // An expression whose value is of(v).greatest, or .least: up() and down() are around what is rounded to the float
  // above or below the nearest; of other quotients the value is given, as near(x / y, 1.5).
  std::string text(Value v, bool greatest, std::span<const std::string> input_names);

 private:
  friend struct Text;
  Reach found(const Node& node);
  Outer outer_found(const Node& node);
  // The reach of each subset of a node's children, by its mask.
  void subsets(const Node& node, std::vector<Reach>& of);

  const Graph& graph_;
  std::span<const float> inputs_;
  std::vector<std::optional<Reach>> reach_;
  std::vector<std::optional<Outer>> outer_;
  std::vector<std::optional<float>> fixed_;
  std::vector<Reach> scratch_;
};

// Calls split(sub, rest) for each way to part a mask of two bits or more in two, each once: sub has its lowest bit.
template <class Split>
void for_each_split(std::uint32_t mask, Split&& split) {
  const std::uint32_t first = mask & (~mask + 1), others = mask ^ first;
  std::uint32_t sub = others;
  do {
    sub = (sub - 1) & others;
    split(sub | first, others ^ sub);
  } while (sub != 0);
}

// The children of a product that are reciprocals, as a mask.
std::uint32_t divisors_of(const Graph& graph, const Node& node);

}  // namespace axiscert::permitted
