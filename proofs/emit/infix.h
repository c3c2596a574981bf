// A recorded program as text with infix operators, in the notation of Coq, Gappa or LaTeX.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proofs/program.h"

namespace axiscert::proofs {

// A step as text, and how tightly the text binds.
struct Text {
  std::string text;
  int binding;  // 1 sum, 2 product, 3 anything that needs no parentheses
};

struct Notation {
  std::string times = " * ";
  // Written around every rounded operation; empty for exact operations.
  std::string round;
  // How a name is written where it is defined and used.
  std::function<std::string(const std::string&)> name = [](const std::string& n) { return n; };
};

struct Definition {
  std::string name, value;
};

// The definitions that the results need, in order: one for each quantity that has a name or is used twice. `results`
// are the results' own texts, not defined unless something else uses them.
struct InfixProgram {
  std::vector<Definition> definitions;
  std::vector<std::string> results;
};
InfixProgram infix(const Program& program, const std::vector<std::size_t>& results, const Notation& notation);

// The same in any notation: `name` writes a name, `write` a step from its operands' texts.
using NameWriter = std::function<std::string(const std::string&)>;
using StepWriter = std::function<Text(const Step& step, const std::vector<Text>& operands)>;
InfixProgram with_definitions(const Program& program, const std::vector<std::size_t>& results, const NameWriter& name,
                              const StepWriter& write);

}  // namespace axiscert::proofs
