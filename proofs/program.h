// A straight-line program: the operations of a formula, step by step, in the order in which they are computed.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kernel/sphere_triangle/names.h"

namespace axiscert::proofs {
enum class Operation : unsigned char { input, zero, negate, add, subtract, multiply, fused };

// The operands are earlier steps. `fused` is operands[0] * operands[1] + operands[2], rounded once.
struct Step {
  Operation operation;
  std::array<std::size_t, 3> operands{};
  std::string name;  // the name of an input, or of a quantity that has an established name; empty otherwise
};
constexpr std::size_t operand_count(Operation operation) {
  switch (operation) {
    case Operation::input:
    case Operation::zero:
      return 0;
    case Operation::negate:
      return 1;
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
      return 2;
    case Operation::fused:
      return 3;
  }
  return 0;
}

class Program {
 public:
  std::size_t input(std::string name);
  // The step with this operation and these operands, an existing one or a new one. Equal steps compute equal bits, so a
  // quantity computed twice is one step.
  std::size_t step(Operation operation, std::array<std::size_t, 3> operands = {});
  // Names a step. A step keeps its first name.
  void name(std::size_t step, const std::string& name);

  const std::vector<Step>& steps() const { return steps_; }
  // The step of that name. Throws std::logic_error if the program has none.
  std::size_t named(const std::string& name) const;
  // The steps on which these results depend, the results included, in order.
  std::vector<std::size_t> needed_by(const std::vector<std::size_t>& results) const;

 private:
  std::vector<Step> steps_;
};

enum class Form : unsigned char { published, reduced };
inline constexpr std::array<std::string_view, 2> form_names = {"published", "reduced"};
// `fma`: dot and cross products with fused multiply-add, kernel/base/number.h.
enum class Contraction : unsigned char { plain, fma };
inline constexpr std::array<std::string_view, 2> contraction_names = {"plain", "fma"};
constexpr std::string_view name(Form f) { return form_names[static_cast<std::size_t>(f)]; }
constexpr std::string_view name(Contraction c) { return contraction_names[static_cast<std::size_t>(c)]; }

// All sixteen comparisons of a set of formulae as one program with the inputs Ax Ay Az Bx ... Pz r.
struct Recording {
  Form form;
  Contraction contraction;
  Program program;
  std::array<std::size_t, comparison_count> lhs, rhs;
};

// Evaluates kernel/sphere_triangle/formulae.h or kernel/sphere_triangle/forms/reduced.h over a number type that
// records its operations.
Recording record(Form form, Contraction contraction);

inline constexpr std::array<std::string_view, 13> input_names = {"Ax", "Ay", "Az", "Bx", "By", "Bz", "Cx",
                                                                 "Cy", "Cz", "Px", "Py", "Pz", "r"};

// A comparison's name as an identifier, with `_` for `.`.
std::string identifier(Comparison which);

// A bound on the rounding error of a recorded program in a format of any number of digits.

// A bound of |(computed lhs - computed rhs) - (lhs - rhs)| for each comparison, where P = 0, every coordinate is in
// [-1, 1], r is in [0, 1], and every operation is rounded to nearest in a format with this number of digits and this
// least exponent. It follows the standard model, step by step: looser than what Gappa proves for 24 and 53 digits, but
// valid for any format.
std::array<double, comparison_count> forward_error(const Recording& recording, int digits, int least_exponent);

}  // namespace axiscert::proofs
