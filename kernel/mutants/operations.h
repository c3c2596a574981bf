// The arithmetic operations of a set of formulae, one by one, in which a fault can be planted. They are found by
// running the formulae over a number type that records its operations, so no formula is stated twice.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernel/query.h"

namespace axiscert::mutants {

enum class Operator : std::uint8_t { plus, minus, times };

// A key for the expression that a number is computed from: the same in every number type, in whatever order a compiler
// evaluates operands. Two numbers of one set of formulae with the same key are the same expression, which recording
// them checks.
using Key = std::uint64_t;
constexpr Key input_key(std::size_t input) { return input + 1; }
inline constexpr Key zero_key = input_key(most_columns);
constexpr Key key_of(Operator op, Key left, Key right) {
  Key key =
      (left * 0x9e3779b97f4a7c15u) ^ (right * 0xc2b2ae3d27d4eb4fu + (static_cast<Key>(op) + 1) * 0x165667b19e3779f9u);
  key ^= key >> 29;
  return key * 0xbf58476d1ce4e5b9u;
}

struct Operation {
  Operator op;
  Key left, right, key;
  std::string text;  // "A.x * B.x"; a result without a name appears as its number, "#17"
};

struct Operations {
  // Each operation once, operands before the operations that use them: those of the first comparison's left side, then
  // of its right side, and so on; within an expression those of the left operand first. The number of an operation is
  // its position here.
  std::vector<Operation> all;
  // The vectors that enter a dot or a cross product; the first three are the vertices relative to the sphere's centre.
  std::vector<std::array<Key, 3>> vectors;
  Key squared_normal;                // e = V.V, the greatest factor of plane.radius's right side
  Key squared_radius, squared_edge;  // r r; AB.AB, the last factor of edge_ab.radius's right side; of the first
                                     // plane and edge, where a predicate has several

  const Operation* find(Key key) const;
};

// The operations of the formulae of a base, by its number (kernel/mutants/mutant.h).
const Operations& operations_of(std::size_t base);

}  // namespace axiscert::mutants
