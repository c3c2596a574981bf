// The files made from the recorded formulae and steps, one or more for each language.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proofs/certified/graph.h"
#include "proofs/program.h"

namespace axiscert::proofs {
// Texts by path: coq/, which completes the theory in proofs/coq; ranges/, which Coq checks beside it; gappa/, fpcore/,
// latex/; programs/, of which programs.txt has the digests; and kernel/, whose header is committed.
using Files = std::map<std::string, std::string>;

Files coq_files();
Files gappa_files();
Files range_files();
Files fpcore_files();
Files latex_files();
// kernel/sphere_triangle/proved_bounds.h.
Files header_files();

// The steps of the certified predicate.
Files certified_files();
// What becomes of blocks of queries; the windows of the exact step.
Files block_files();
// A step as a program: an operation a line.
std::string text_of(const certified::RecordedStep& step);
// The path of a program: a step, or a set of formulae.
std::string program_path(std::string_view name);

// All of these files.
Files proof_files();

// A recorded program as text with infix operators, in the notation of Coq, Gappa or LaTeX.

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
